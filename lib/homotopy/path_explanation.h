#pragma once

// What happened on a path, in words about its figures.

#include <string>
#include <vector>

#include "geometry/geometric_equations.h"
#include "homotopy/figure_curve.h"
#include "homotopy/path_tracker.h"

namespace gcslab {

struct PathExplanation {
  std::vector<std::string> branch_points;  ///< "all points are coplanar", one a branch point
  std::string end, other_end;              ///< of the last figures; empty for a return to the sketch
};

/// Names what is special about the figures of branch points and ends, and tells more of the ends: a path that
/// is stuck on figures of which points are far away goes to infinity, and one that is stuck where the
/// equations are not smooth or their Jacobian loses rank, to an undefined point. `extent` is the size of
/// usual figures on the path.
PathExplanation explain(Path& path, const ConstraintSystem& system, const GeometricEquations& equations,
                        FigureCurve& curve, double extent);

}  // namespace gcslab
