#pragma once

// The solutions on the path of a sketch: every crossing of t = 1, polished, certified where it is regular,
// and listed once.

#include <optional>
#include <string>

#include "certification/root_certificate.h"
#include "certification/system_functions.h"
#include "homotopy/figure_curve.h"
#include "homotopy/path_tracker.h"

namespace gcslab {

struct SketchSolution {
  std::vector<double> unknowns;
  std::optional<CertifiedRoot> root;  ///< nothing: no theorem applies, as where the Jacobian is singular
  std::size_t rank;                   ///< of the Jacobian, as far as doubles tell
  bool is_on_continuum = false;       ///< numerical evidence
};

struct SketchSolutions {
  Path path;
  std::vector<SketchSolution> solutions;          ///< distinct, in the order met
  std::vector<std::size_t> solution_of_crossing;  ///< number of the solution, one a crossing of the path
};

/// Certifies what a path crosses in the box of `wanted`, the equations at t = 1; other crossings are dropped,
/// as those where a radius is negative. `certifier` names theorems (certification/root_certifier.h).
SketchSolutions solutions_of(Path path, FigureCurve& figures, const SystemFunctions& wanted,
                             const std::string& certifier);

/// Follows the path through `start`, a point with t = 0, and lists its solutions. `curve` is that of the
/// figures, perhaps with other derivatives.
SketchSolutions solve_along_path(FigureCurve& figures, Curve& curve, const std::vector<double>& start,
                                 const SystemFunctions& wanted, const TrackerOptions& options,
                                 const std::string& certifier, const std::stop_token& stop = {},
                                 const PathAids& aids = {});

}  // namespace gcslab
