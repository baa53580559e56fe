#include "experiments/solving/solve_run.h"

#include "base/error.h"
#include "box_solver/univariate_search.h"

namespace gcslab {
namespace {

Status status_of(const SearchResult& found, Promise promise) {
  if (!found.pending.empty()) return Status::budget_exhausted;
  if (promise == Promise::baseline || !found.undecided.empty()) return Status::partial;
  return Status::complete;
}

SolveOutcome solve_univariate(const SystemFunctions& functions, const SolveSettings& settings,
                              bool is_resumed, const std::stop_token& stop) {
  if (is_resumed) throw NotApplicable(settings.method + " does not resume interrupted searches");
  SolveOutcome outcome;
  outcome.search = univariate_search(functions, functions.system().box, settings.proof, stop);
  outcome.status = status_of(outcome.search, Promise::rigorous);
  outcome.completeness = "proved";
  return outcome;
}

}  // namespace

SolveOutcome solve_system(const SystemFunctions& functions, const SolveSettings& settings,
                          const std::optional<SearchStart>& start, const std::stop_token& stop,
                          SearchObserver* observer) {
  if (solver_method_registry().at(settings.method).engine == SolverEngine::univariate)
    return solve_univariate(functions, settings, start.has_value(), stop);
  SearchOptions options = search_options(settings.options);
  options.threads = settings.threads;
  options.proof = settings.proof;
  options.record = settings.record;
  const Box& box = functions.system().box;
  SolveOutcome outcome;
  outcome.search = search(functions, box, start ? *start : SearchStart{{box}},
                          contractor_maker(settings.options), options, stop, observer);
  const Promise promise = SolverMethod::promise(settings.options);
  outcome.status = status_of(outcome.search, promise);
  outcome.completeness = promise == Promise::rigorous ? "proved" : "none";
  return outcome;
}

}  // namespace gcslab
