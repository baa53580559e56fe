#pragma once

// The solutions on the path of a sketch: every crossing of t = 1, polished, certified where it is regular,
// and listed once.

#include <optional>
#include <string>

#include "certification/root_certificate.h"
#include "certification/system_functions.h"
#include "homotopy/path_tracker.h"
#include "homotopy/starting_figure.h"

namespace gcslab {

struct SketchSolution {
  std::vector<double> unknowns;
  std::optional<CertifiedRoot> root;  ///< nothing: no theorem applies, as where the Jacobian is singular
};

struct SketchSolutions {
  SketchPath path;
  std::vector<SketchSolution> solutions;          ///< distinct, in the order met
  std::vector<std::size_t> solution_of_crossing;  ///< number of the solution, one a crossing of the path
};

/// Follows the path of the starting figure and certifies what it crosses. `wanted` are the equations with the
/// values at t = 1; `certifier` names theorems (certification/root_certifier.h).
SketchSolutions solve_along_path(Homotopy& homotopy, const StartingFigure& start,
                                 const SystemFunctions& wanted, const TrackerOptions& options,
                                 const std::string& certifier, const std::stop_token& stop = {});

}  // namespace gcslab
