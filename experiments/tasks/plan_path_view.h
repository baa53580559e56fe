#pragma once

// The path of a reparametrised problem in the plane of its one guide parameter and t, for drawings.

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "construction/plan_homotopy.h"
#include "construction/plan_simplices.h"
#include "experiments/corpus/problem.h"

namespace gcslab {

/// Guide, in the unit of the problem's lengths, and t.
using GuidePoint = std::array<double, 2>;
using GuideLine = std::vector<GuidePoint>;

struct GuideRange {
  GuidePoint low, high;
};

/// Part of a path on one branch.
struct BranchArc {
  Branch branch;
  GuideLine points;
};

/// A simplex that a path passes.
struct DrawnSimplex {
  std::array<GuidePoint, 3> corners;
  std::array<bool, 3> is_inside;
  GuidePoint exit;                  ///< of the interpolated curve
  std::optional<GuideLine> border;  ///< two points of the line that stands for the border
  Branch branch;
};

class PlanPathView {
 public:
  /// The problem's own sketch, and the plan with the fewest guides. Throws NotApplicable unless that has one
  /// guide, and what PlanHomotopy throws.
  explicit PlanPathView(const std::filesystem::path& problem);

  const ConstraintSystem& system() const { return problem_.geometry->system; }
  const Plan& plan() const { return homotopy_->program().plan(); }
  /// "k0 = distance P3 P0".
  std::string guide_text() const;

  /// The arcs in the order of the path; the sketch is the first point of the first when the path is a cycle.
  struct Followed {
    std::vector<BranchArc> arcs;
    std::vector<GuidePoint> crossings;  ///< of t = 1
    std::size_t simplices = 0;
    bool is_cycle = false;
    GuidePoint sketch;
  };
  Followed follow(double mesh);
  /// Those that a path passes before it has changed its branch `change` times, and `after` more; the last
  /// `before` of the first.
  std::vector<DrawnSimplex> simplices_around(std::size_t change, double mesh, std::size_t before,
                                             std::size_t after);

  /// The border of the domain of a branch within a range, found on a grid of so many squares each way.
  std::vector<GuideLine> border(const Branch& branch, const GuideRange& range, int resolution);
  bool is_inside(const Branch& branch, const GuidePoint& point);
  /// What the plan constructs there.
  Figure figure(const Branch& branch, const GuidePoint& point);

 private:
  GuidePoint point_of(const std::vector<double>& v) const { return {v[0] * map_->unit(), v[1]}; }

  Problem problem_;
  std::optional<SketchHomotopy> sketched_;
  std::optional<PlanHomotopy> homotopy_;
  std::optional<BranchMap> map_;
};

}  // namespace gcslab
