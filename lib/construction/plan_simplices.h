#pragma once

// The path of a reparametrised system in the space of guide parameters and t, through simplices (Imbach 2013,
// section 4.3.2).
//
// Where a vertex of the current simplex is outside of the domain of the branch, the border is taken for the
// hyperplane through points of the border on edges between vertices inside and outside. The new branch is
// that with the choice inverted whose radicand is negative there; its function at the mirror image of the
// vertex stands for the function of the old branch at the vertex. When all vertices are outside, the simplex
// is replaced by its mirror image, and the new branch is the current one.

#include <functional>
#include <optional>

#include "construction/branch_map.h"
#include "homotopy/path_tracker.h"

namespace gcslab {

struct PlanSimplexOptions {
  double mesh = 1e-3;
  double infinity = 1e5;
  std::uint64_t maximum_simplices = 10'000'000;
  bool is_to_first_crossing = false;
};

/// A point of the path on a branch.
struct BranchCrossing {
  std::vector<double> v;  ///< guides / unit, t
  Branch branch;
  double length;
};

struct PlanSimplexPath {
  PathEnd end = PathEnd::budget, other_end = PathEnd::budget;
  std::vector<BranchCrossing> crossings;  ///< of t = 1, polished on their branch
  std::vector<BranchCrossing> changes;    ///< of the branch: the branch that begins there
  std::uint64_t simplices = 0;
  double length = 0;
  std::string failure{};  ///< why a change of branch failed
};

/// A simplex that the path passes, when it is passed.
struct PassedSimplex {
  const std::vector<std::vector<double>>& vertices;
  const std::vector<bool>& is_inside;  ///< of each vertex: in the domain of the branch
  const Branch& branch;
  /// The hyperplane that stands for the border, where not all vertices are inside: normal . v = offset.
  struct Border {
    std::vector<double> normal;
    double offset;
  };
  const std::optional<Border>& border;
  const std::vector<double>& exit;      ///< the zero of the interpolated map in the face that it leaves by
  const std::vector<double>& on_curve;  ///< the same point, or its mirror image where it is beyond the border
  const Branch& curve_branch;           ///< of that point
  int direction;  ///< 1, or -1 for the part of the path that leaves the sketch backwards
};
using SimplexObserver = std::function<void(const PassedSimplex&)>;

/// Follows the path through the values of a sketch, on its branch. A failed change of branch ends the path
/// as `stuck`.
PlanSimplexPath follow_plan_simplices(BranchMap& map, const PlanValues& start,
                                      const PlanSimplexOptions& options, const std::stop_token& stop = {},
                                      const SimplexObserver& observer = {});

}  // namespace gcslab
