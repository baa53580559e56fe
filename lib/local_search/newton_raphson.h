#pragma once

#include <stop_token>

#include "certification/system_functions.h"
#include "local_search/local_search.h"

namespace gcslab {

struct NewtonRaphsonOptions : LocalSearchOptions {
  /// Steps are halved until the sum of squares falls (Armijo's rule). Off: the plain method.
  bool is_damped = false;
};

/// Newton and Raphson's iteration for a square system: x - J(x)^-1 f(x), as often as it takes. It converges
/// quadratically near a regular root, linearly near a singular one, and need not converge at all.
LocalSearch newton_raphson(const SystemFunctions& functions, std::vector<double> start,
                           const NewtonRaphsonOptions& options, const std::stop_token& stop = {});

}  // namespace gcslab
