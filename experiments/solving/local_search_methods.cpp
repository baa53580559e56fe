// The methods `newton_from_sketch`, `levenberg_marquardt_from_sketch` and `bfgs_from_sketch`: one search in
// plain doubles from the sketch as it was drawn, with the equations of the wanted values.

#include <algorithm>

#include "base/error.h"
#include "certification/point_certifier.h"
#include "experiments/solving/sketch_source.h"
#include "experiments/solving/solve_method.h"
#include "homotopy/starting_figure.h"
#include "local_search/newton_raphson.h"
#include "local_search/sum_of_squares.h"

namespace gcslab {
namespace {

using Start = std::vector<double>;
/// A search from a start, with the options of its method.
using Searcher = LocalSearch (*)(const SystemFunctions&, Start, const Options&, const std::stop_token&);

LocalSearchOptions search_limits(const Options& options) {
  return {static_cast<std::uint64_t>(options.integer("maximum_iterations")), options.real("tolerance")};
}

LocalSearch run_newton(const SystemFunctions& functions, Start start, const Options& options,
                       const std::stop_token& stop) {
  if (!functions.is_square()) throw NotApplicable("Newton's method needs as many equations as unknowns");
  return newton_raphson(functions, std::move(start), {search_limits(options), options.flag("damping")}, stop);
}

template <Minimiser minimiser>
LocalSearch run_minimiser(const SystemFunctions& functions, Start start, const Options& options,
                          const std::stop_token& stop) {
  return minimise_squares(functions, std::move(start), minimiser, search_limits(options), stop);
}

/// A proof of uniqueness supposes as many equations as unknowns.
std::optional<CertifiedRoot> certified(const SystemFunctions& functions, const Start& point,
                                       const std::string& certifier) {
  if (!functions.is_square()) return std::nullopt;
  return PointCertifier(functions, certifier).certify(point);
}

/// Whether the solution may lie in the box. Without certificate it is known about as well as the tolerance
/// says, and less well where it is singular.
bool may_lie_in(const Solution& solution, const Box& box) {
  constexpr double kSlack = 1e-6;
  double size = 0;
  for (const Interval& side : solution.root.box) size = std::max(size, magnitude(side));
  const double reach = solution.claim == Claim::none ? kSlack * size : 0;
  for (std::size_t i = 0; i < box.size(); ++i) {
    const Interval& side = solution.root.box[i];
    if (side.upper + reach < box[i].lower || box[i].upper < side.lower - reach) return false;
  }
  return true;
}

SolveOutcome outcome_of(const LocalSearch& found, const SystemFunctions& functions,
                        const std::string& certifier) {
  SolveOutcome outcome;
  outcome.status = found.end == LocalSearchEnd::stopped ? Status::budget_exhausted : Status::partial;
  outcome.steps = found.iterations;
  if (found.end != LocalSearchEnd::root) {
    outcome.reason = "the search from the sketch " + end_text(found);
    return outcome;
  }
  Solution solution = found_solution(found.point, certified(functions, found.point, certifier));
  if (may_lie_in(solution, functions.system().box)) {
    outcome.search.solutions.push_back(std::move(solution));
  } else {
    outcome.reason = "the search from the sketch ended at a root outside of the box of the problem";
  }
  return outcome;
}

template <Searcher searcher>
SolveOutcome solve_from_sketch(const SystemFunctions& functions, const SolveSettings& settings,
                               const std::optional<SearchStart>&, const std::stop_token& stop,
                               SearchObserver*) {
  const auto [geometry, sketch] = sketch_source(settings);
  const std::string& certifier = settings.options.word("certifier");
  check_certifier(certifier);
  Start start = drawn_unknowns(geometry.system, geometry.frame, geometry.equations, sketch);
  return outcome_of(searcher(functions, std::move(start), settings.options, stop), functions, certifier);
}

template <Searcher searcher>
SolveMethod method(std::string name, std::string summary, std::int64_t iterations) {
  return {std::move(name),
          std::move(summary),
          1,
          {integer_option("maximum_iterations", "of the search", "iterations", iterations, 1, 1'000'000'000),
           real_option("tolerance",
                       "a point is a root when, to first order, every equation vanishes within this part of "
                       "the figure's size",
                       "", 1e-10, 1e-15, 1e-2),
           random_sketch_option(),
           OptionSpec{"certifier", "what proves the solution: names of theorems, joined by +",
                      std::string("krawczyk_slopes+kantorovich")}},
          solve_from_sketch<searcher>,
          Promise::rigorous,
          {},
          "goes from the sketch to one solution"};
}

}  // namespace

std::vector<SolveMethod> local_search_methods() {
  SolveMethod newton = method<run_newton>(
      "newton_from_sketch",
      "constraint systems: Newton and Raphson's iteration from the sketch; one solution or none", 100);
  newton.options.push_back(
      flag_option("damping", "halve steps until the sum of squares falls (Armijo's rule)", false));
  return {std::move(newton),
          method<run_minimiser<Minimiser::levenberg_marquardt>>(
              "levenberg_marquardt_from_sketch",
              "constraint systems: Levenberg and Marquardt's least squares from the sketch; one solution or "
              "none",
              1000),
          method<run_minimiser<Minimiser::bfgs>>("bfgs_from_sketch",
                                                 "constraint systems: the sum of squares minimised by BFGS "
                                                 "from the sketch (Ge, Chou, Gao 1999); one solution or none",
                                                 10'000)};
}

}  // namespace gcslab
