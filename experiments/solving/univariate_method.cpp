// The isolation of roots of one polynomial in one variable, as a method of `solve`.

#include "base/error.h"
#include "box_solver/univariate_search.h"
#include "experiments/solving/solve_method.h"

namespace gcslab {
namespace {

SolveOutcome solve(const SystemFunctions& functions, const SolveSettings& settings,
                   const std::optional<SearchStart>& start, const std::stop_token& stop, SearchObserver*) {
  if (start) throw NotApplicable(settings.method + " does not resume interrupted searches");
  SolveOutcome outcome;
  outcome.search = univariate_search(functions, functions.system().box, settings.proof, stop);
  outcome.status = status_of(outcome.search, Promise::rigorous);
  outcome.completeness = "proved";
  return outcome;
}

}  // namespace

SolveMethod univariate_method() {
  return {
      "univariate_bernstein",
      "one polynomial in one variable: every real root with its multiplicity, exactly, by Descartes' rule "
      "in the Bernstein basis (Collins, Akritas 1976; Lane, Riesenfeld 1981)",
      1,
      {},
      solve};
}

}  // namespace gcslab
