#include "experiments/solving/solve_method.h"

namespace gcslab {
namespace {

SolveOutcome solve_by_search(const SystemFunctions& functions, const SolveSettings& settings,
                             const std::optional<SearchStart>& start, const std::stop_token& stop,
                             SearchObserver* observer) {
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

OptionSpec valuation_option() {
  return {"valuation", "of a constraint system: which values its parameters have; empty: the first",
          std::string()};
}

std::vector<SolveMethod> all_methods() {
  std::vector<SolveMethod> methods;
  for (const SolverMethod& method : solver_method_registry().entries())
    methods.push_back({method.name, method.summary, method.version, method.options(), solve_by_search,
                       Promise::rigorous, &SolverMethod::promise});
  methods.push_back(univariate_method());
  methods.push_back(angle_sum_method());
  for (SolveMethod& method : sketch_path_methods()) methods.push_back(std::move(method));
  for (SolveMethod& method : plan_methods()) methods.push_back(std::move(method));
  methods.push_back(plan_evaluation_method());
  for (SolveMethod& search : local_search_methods()) methods.push_back(std::move(search));
  for (SolveMethod& peer : peer_methods()) methods.push_back(std::move(peer));
  for (SolveMethod& method : methods) method.options.push_back(valuation_option());
  return methods;
}

}  // namespace

Status status_of(const SearchResult& found, Promise promise) {
  if (!found.pending.empty()) return Status::budget_exhausted;
  if (promise == Promise::baseline || !found.undecided.empty()) return Status::partial;
  return Status::complete;
}

const Registry<SolveMethod>& solve_method_registry() {
  static const Registry<SolveMethod> registry("method", all_methods());
  return registry;
}

}  // namespace gcslab
