// The method `angle_sum`: circle packings through the angle sums of their radii (packing/packing_solver.h).

#include "base/error.h"
#include "experiments/solving/solve_method.h"
#include "packing/packing_solver.h"

namespace gcslab {
namespace {

SolveOutcome solve_by_angle_sums(const SystemFunctions& functions, const SolveSettings& settings,
                                 const std::optional<SearchStart>& start, const std::stop_token& stop,
                                 SearchObserver*) {
  if (start) throw NotApplicable("angle_sum does not search, so that nothing is left to go on from");
  const PackingSolverOptions options = {
      .bits = static_cast<int>(settings.options.integer("bits")),
      .maximum_bits = static_cast<int>(settings.options.integer("maximum_bits")),
      .proof = settings.proof};
  SolveOutcome outcome;
  outcome.search = solve_packing(functions, functions.system().box, options, stop);
  outcome.status = status_of(outcome.search, Promise::rigorous);
  outcome.completeness = "proved";
  return outcome;
}

}  // namespace

SolveMethod angle_sum_method() {
  return {"angle_sum",
          "circle packings only: radii from the angle sums, a layout in intervals, and a certificate for it "
          "in x, "
          "y, r (Thurston 1978; Collins, Stephenson 2003)",
          1,
          {integer_option("bits", "precision of radii and layout at first", "bits", 128, 64, 100'000),
           integer_option("maximum_bits", "precision goes up to this where the layout is too wide", "bits",
                          1024, 64, 100'000)},
          solve_by_angle_sums};
}

}  // namespace gcslab
