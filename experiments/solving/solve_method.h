#pragma once

// Every method of `solve`: the settings of the branch-and-prune engine (box_solver/solver_method.h), and
// methods of other kinds, one file each.

#include <functional>

#include "base/registry.h"
#include "experiments/solving/solve_run.h"

namespace gcslab {

struct SolveMethod {
  std::string name;
  std::string summary;
  int version;  ///< raised when answers or counts change
  std::vector<OptionSpec> options;
  /// Solves, or goes on from what an interrupted run left. Throws NotApplicable with the reason.
  std::function<SolveOutcome(const SystemFunctions&, const SolveSettings&, const std::optional<SearchStart>&,
                             const std::stop_token&, SearchObserver*)>
      solve;
  Promise promise = Promise::rigorous;
  /// Where some options are baselines: the promise of the method with these. Empty: `promise`.
  std::function<Promise(const Options&)> promise_with{};
  /// Empty, or what it does that is no search: it writes no proof, and cannot be resumed unless it follows a
  /// path.
  std::string no_search{};
  bool follows_path = false;
};

const Registry<SolveMethod>& solve_method_registry();

/// What the outcome's words follow from.
Status status_of(const SearchResult& found, Promise promise);

// The methods that are no settings of the engine.
SolveMethod univariate_method();
SolveMethod angle_sum_method();
std::vector<SolveMethod> sketch_path_methods();
std::vector<SolveMethod> plan_methods();
SolveMethod plan_evaluation_method();
std::vector<SolveMethod> local_search_methods();
std::vector<SolveMethod> peer_methods();

}  // namespace gcslab
