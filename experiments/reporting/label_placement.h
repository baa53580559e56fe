#pragma once

// Places for short texts in a drawing: near what they name, and off the lines, points and texts around.
//
// Lengths are millimetres on paper.

#include <array>
#include <string>
#include <vector>

namespace gcslab {

using PaperPoint = std::array<double, 2>;

struct PaperSegment {
  PaperPoint from, to;
};

/// An upright rectangle around a text.
struct PaperBox {
  PaperPoint centre;
  double width, height;

  bool overlaps(const PaperBox& other) const;
  /// The length of the segment's part inside.
  double length_inside(const PaperSegment& segment) const;
};

class LabelPlacer {
 public:
  /// Texts stay inside `page`.
  LabelPlacer(PaperBox page, std::vector<PaperSegment> lines, std::vector<PaperPoint> points);

  /// A place beside a point, by preference on the side of `away`, a direction or 0.
  PaperPoint beside_point(const PaperPoint& point, const PaperPoint& away, const std::string& text);
  /// A place beyond a point, by preference in that direction and near, else around it.
  PaperPoint beyond_point(const PaperPoint& point, const PaperPoint& direction, const std::string& text);
  /// A place beside a line, by preference at its middle.
  PaperPoint beside_line(const PaperSegment& line, const std::string& text);
  /// A place beside any of these pieces of a curve.
  PaperPoint beside_curve(const std::vector<PaperSegment>& pieces, const std::string& text);

 private:
  struct Candidate {
    PaperPoint centre;
    double penalty;  ///< in millimetres of line that a text may cover instead
  };
  PaperPoint best_of(const std::vector<Candidate>& candidates, double width, double height);
  double disturbance(const PaperBox& box) const;

  PaperBox page_;
  std::vector<PaperSegment> lines_;
  std::vector<PaperPoint> points_;
  std::vector<PaperBox> placed_;
};

}  // namespace gcslab
