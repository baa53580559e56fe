#pragma once

// The sum of the squares of a system's equations, minimised from a point. Its minima of value 0 are the
// roots; a search may end at another one. The system need not be square (Ge, Chou, Gao 1999).

#include <stop_token>

#include "certification/system_functions.h"
#include "local_search/local_search.h"

namespace gcslab {

enum class Minimiser {
  levenberg_marquardt,  ///< Gauss and Newton's steps in a trust region (Levenberg 1944, Marquardt 1963)
  bfgs                  ///< quasi-Newton steps with strong Wolfe line searches (Ge, Chou, Gao 1999)
};

/// By Ceres Solver, on one thread: the same start gives the same search.
LocalSearch minimise_squares(const SystemFunctions& functions, std::vector<double> start, Minimiser minimiser,
                             const LocalSearchOptions& options, const std::stop_token& stop = {});

}  // namespace gcslab
