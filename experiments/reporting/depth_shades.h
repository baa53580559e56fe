#pragma once

// Lines of figures in space, darker and thicker where they are nearer.

#include <array>
#include <string>
#include <string_view>

#include "experiments/reporting/axonometry.h"

namespace gcslab {

inline constexpr std::size_t kDepths = 6;

/// How lines of one depth look.
struct Shade {
  std::string colour;
  double line_width;
};
/// From the farthest to the nearest.
using Shades = std::array<Shade, kDepths>;

/// Of the edges between points.
const Shades& edge_shades();
/// From a pale tint to the colour itself.
Shades shades_of(std::string_view colour, double line_width);

/// Which shade what is that far away has, between the nearest and the farthest part of a figure.
class DepthScale {
 public:
  /// All parts of a figure whose size on paper is `size`.
  DepthScale(double nearest, double farthest, double size);

  /// Real, so that lines can be cut where it becomes whole.
  double shade_at(double away) const;
  std::size_t number_at(double away) const { return number_of(shade_at(away)); }
  static std::size_t number_of(double shade);

 private:
  double nearest_, farthest_, size_;
};

/// Pieces of lines as data lines, by their shade; pieces that follow each other are one line.
class ShadedLines {
 public:
  explicit ShadedLines(const DepthScale& scale) : scale_(scale) {}

  /// What is hidden is as pale as what is far away.
  void add(const SeenPoint& from, const SeenPoint& to, bool is_hidden);
  const std::string& lines(std::size_t shade) const { return lines_[shade]; }

 private:
  void put(const std::string& from, const std::string& to, std::size_t shade);

  const DepthScale& scale_;
  std::array<std::string, kDepths> lines_;
  std::size_t last_shade_ = kDepths;
  std::string last_;  ///< point
};

/// A shade for what is behind or within a surface.
std::size_t veiled(std::size_t shade);

/// "x y" with a line end.
std::string point_line(double x, double y);

}  // namespace gcslab
