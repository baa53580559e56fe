#include "experiments/solving/solve_run.h"

#include "experiments/solving/solve_method.h"

namespace gcslab {

SolveOutcome solve_system(const SystemFunctions& functions, const SolveSettings& settings,
                          const std::optional<SearchStart>& start, const std::stop_token& stop,
                          SearchObserver* observer) {
  return solve_method_registry().at(settings.method).solve(functions, settings, start, stop, observer);
}

}  // namespace gcslab
