// The method `sketch_path`: the homotopy path of a constraint system's sketch, followed as a whole.

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "certification/root_certifier.h"
#include "experiments/solving/solve_method.h"
#include "geometry/sketch.h"
#include "homotopy/sketch_solver.h"

namespace gcslab {
namespace {

/// The first length whose equation tells its sign.
std::size_t supporting_parameter(const ConstraintSystem& system) {
  for (const Constraint& constraint : system.constraints) {
    const bool is_length = constraint.kind->name == "distance";
    if (is_length && constraint.kind->interpretations[constraint.interpretation].name == "norm")
      return *constraint.parameter;
  }
  throw NotApplicable("interpolation=compact_support needs a distance with interpretation: norm");
}

std::unique_ptr<ParameterPath> interpolation(const std::string& name, const ConstraintSystem& system,
                                             std::vector<double> sketch, std::vector<double> wanted) {
  if (name == "linear") return linear_path(std::move(sketch), std::move(wanted));
  return compact_support_path(std::move(sketch), std::move(wanted), supporting_parameter(system));
}

TrackerOptions tracker_options(const Options& options) {
  TrackerOptions result;
  result.first_step = options.real("first_step");
  result.largest_step = options.real("largest_step");
  result.tolerance = options.real("tolerance");
  result.largest_turn = options.real("largest_turn");
  result.maximum_steps = static_cast<std::uint64_t>(options.integer("maximum_steps"));
  return result;
}

Box box_around(const std::vector<double>& point) {
  Box box;
  for (const double x : point) box.emplace_back(x);
  return box;
}

SolveOutcome solve_along_sketch(const SystemFunctions& functions, const SolveSettings& settings,
                                const std::optional<SearchStart>&, const std::stop_token& stop,
                                SearchObserver*) {
  if (settings.geometry == nullptr) throw NotApplicable("only constraint systems have a sketch");
  const ConstraintSystem& system = settings.geometry->system;
  const GeometricEquations& equations = settings.geometry->equations;
  if (!functions.is_square()) throw NotApplicable(balance_text(equations));
  const std::optional<Figure> sketch = sketch_of(system);
  if (!sketch)
    throw NotApplicable("the problem has no sketch: add the key `sketch`, coordinates or {random: 1}");
  const std::string& certifier = settings.options.word("certifier");
  check_certifier(certifier);
  const StartingFigure first = starting_figure(system, settings.geometry->frame, equations, *sketch);
  Homotopy homotopy(equations, interpolation(settings.options.word("interpolation"), system, first.parameters,
                                             values_of(system.valuation(settings.geometry->valuation))));
  SketchSolutions found =
      solve_along_path(homotopy, first, functions, tracker_options(settings.options), certifier, stop);
  SolveOutcome outcome;
  for (SketchSolution& solution : found.solutions) {
    outcome.search.solutions.push_back(
        solution.root ? Solution{std::move(*solution.root)}
                      : Solution{.root = {box_around(solution.unknowns), {}, {}}, .claim = Claim::none});
  }
  outcome.status = found.path.end == PathEnd::budget || found.path.other_end == PathEnd::budget
                       ? Status::budget_exhausted
                       : Status::partial;
  outcome.paths.push_back({std::move(found.path), std::move(found.solution_of_crossing)});
  return outcome;
}

}  // namespace

SolveMethod sketch_path_method() {
  return {
      "sketch_path",
      "constraint systems: the homotopy path of the sketch, followed as a whole; each crossing of t = 1 is a "
      "solution (Imbach 2013)",
      1,
      {choice_option("interpolation", "of the parameters between the sketch and what is wanted", "linear",
                     {"linear", "compact_support"}),
       real_option("first_step", "length of the first step, in unknowns and t", "", 0.01, 1e-12, 1e6),
       real_option("largest_step", "no step is longer", "", 0.5, 1e-12, 1e6),
       real_option("tolerance", "of the last correction of a point, relative to its size", "", 1e-6, 1e-14,
                   1e-2),
       real_option("largest_turn", "of the tangent in one step", "radians", 0.4, 1e-3, 1.5),
       integer_option("maximum_steps", "work budget", "steps", 1'000'000, 1, 1'000'000'000),
       OptionSpec{"certifier", "what proves solutions: names of theorems, joined by +",
                  std::string("krawczyk_slopes+kantorovich")}},
      solve_along_sketch,
      Promise::rigorous,
      {},
      "follows a path"};
}

}  // namespace gcslab
