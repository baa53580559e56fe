// Methods that construct the figures of a constraint system by a plan.

#include <fmt/format.h>

#include "base/error.h"
#include "certification/root_certifier.h"
#include "construction/exploration.h"
#include "construction/plan_homotopy.h"
#include "experiments/solving/path_settings.h"
#include "experiments/solving/sketch_source.h"
#include "geometry/degrees_of_freedom.h"
#include "geometry/sketch.h"

namespace gcslab {
namespace {

OptionSpec plan_option(const std::string& usual) {
  return choice_option(
      "plan",
      "how it is chosen: forward or backward (gao) by counting, with the least number of guide "
      "parameters of all orders of the points, or by distances alone (henneberg)",
      usual, {"forward", "gao", "least", "henneberg"});
}

PlanKind plan_kind(const Options& options) {
  const std::string& name = options.word("plan");
  if (name == "forward") return PlanKind::forward;
  if (name == "gao") return PlanKind::gao;
  return name == "least" ? PlanKind::least : PlanKind::henneberg;
}

std::vector<std::string> lines_of(const std::string& text, char end) {
  std::vector<std::string> lines;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t next = std::min(text.find(end, at), text.size());
    if (next > at) lines.push_back(text.substr(at, next - at));
    at = next + 1;
  }
  return lines;
}

PlanReport report_of(const Plan& plan, const ConstraintSystem& system) {
  return {lines_of(text_of(plan, system), '\n'), plan.guides.size(), plan.choices(), plan.removed.size()};
}

/// What the methods are given, checked.
struct PlanSource {
  explicit PlanSource(const SystemFunctions& functions, const SolveSettings& settings)
      : source(sketch_source(settings)),
        system(source.geometry.system),
        equations(source.geometry.equations),
        wanted(values_of(system.valuation(source.geometry.valuation))) {
    if (!functions.is_square())
      throw NotApplicable(balance_text(equations) + "; " +
                          structure_text(system, structural_diagnosis(equations)));
    check_certifier(settings.options.word("certifier"));
  }

  SketchSource source;
  const ConstraintSystem& system;
  const GeometricEquations& equations;
  std::vector<double> wanted;
};

SolveOutcome solve_along_plan(const SystemFunctions& functions, const SolveSettings& settings,
                              const std::optional<SearchStart>&, const std::stop_token& stop,
                              SearchObserver*) {
  const PlanSource given(functions, settings);
  const Options& options = settings.options;
  const Frame& frame = given.source.geometry.frame;
  const SketchHomotopy sketched(given.system, frame, given.equations, given.wanted, given.source.sketch,
                                homotopy_options(options));
  PlanHomotopy homotopy(given.system, frame, given.equations, sketched, plan_kind(options));
  PlanCurve& curve = homotopy.curve();
  Tracer tracer(settings, curve, given.equations);
  FollowedPath followed{
      solve_along_path(curve, curve, curve.start(), functions,
                       tracker_options(options, sketched.extent() / sketched.unit()),
                       options.word("certifier"), stop, {tracer.observer(), settings.path_from}),
      {}};
  followed.trace = tracer.traced(followed.found.path, curve.start(), false);
  followed.explanation =
      explain(followed.found.path, given.system, given.equations, curve, sketched.extent());
  SolveOutcome outcome = outcome_of(std::move(followed), false);
  outcome.plan = report_of(homotopy.program().plan(), given.system);
  return outcome;
}

SolveOutcome explore_sketches(const SystemFunctions& functions, const SolveSettings& settings,
                              const std::optional<SearchStart>&, const std::stop_token& stop,
                              SearchObserver*) {
  const PlanSource given(functions, settings);
  const Options& options = settings.options;
  ExplorationOptions exploration;
  exploration.plan = plan_kind(options);
  exploration.homotopy = homotopy_options(options);
  exploration.tracker = tracker_options(options, 1);
  exploration.certifier = options.word("certifier");
  exploration.maximum_paths = static_cast<std::uint64_t>(options.integer("maximum_paths"));
  if (options.word("sketches") != "all") exploration.branches = lines_of(options.word("sketches"), '/');
  Exploration found = explore(given.system, given.source.geometry.frame, given.equations, given.wanted,
                              given.source.sketch, functions, exploration, stop);
  SolveOutcome outcome;
  for (const SketchSolution& solution : found.solutions)
    outcome.search.solutions.push_back(found_solution(solution.unknowns, solution.root));
  outcome.status = found.is_finished ? Status::partial : Status::budget_exhausted;
  outcome.steps = 0;
  for (ExploredPath& path : found.paths) {
    *outcome.steps += path.found.path.steps;
    FollowedPath followed{std::move(path.found), std::move(path.explanation), std::move(path.numbers)};
    if (path.sketch.solution)
      followed.origin =
          fmt::format("class {}, branch {}", *path.sketch.solution, text_of(path.sketch.branch));
    if (path.refused.empty()) outcome.paths.push_back(std::move(followed));
  }
  outcome.plan = report_of(found.plan, given.system);
  outcome.plan->sketches = found.sketches;
  return outcome;
}

std::vector<OptionSpec> shared_options(const std::string& plan, std::vector<OptionSpec> own) {
  std::vector<OptionSpec> specs = {plan_option(plan)};
  const auto add = [&](const std::vector<OptionSpec>& more) {
    specs.insert(specs.end(), more.begin(), more.end());
  };
  add(own);
  add(homotopy_option_specs());
  add({random_sketch_option()});
  add(tracker_option_specs());
  add({certifier_option()});
  return specs;
}

}  // namespace

std::vector<SolveMethod> plan_methods() {
  return {
      {"plan_path",
       "constraint systems: the homotopy path of the sketch in the guide parameters and heights of a "
       "construction plan (after Gao, Hoffmann, Yang 2004 and Imbach 2013)",
       1,
       shared_options("least", {}),
       solve_along_plan,
       Promise::rigorous,
       {},
       "follows a path",
       true},
      {"plan_exploration",
       "constraint systems: new sketches from every solution by the branches of a construction plan, and the "
       "path of each, until nothing new is found; a solution a class (Imbach 2013)",
       1,
       shared_options("least",
                      {integer_option("maximum_paths", "work budget", "paths", 100'000, 1, 1'000'000'000),
                       OptionSpec{"sketches", "branches whose sketches are followed, as +-+/++-, or all",
                                  std::string("all")}}),
       explore_sketches,
       Promise::rigorous,
       {},
       "follows paths"}};
}

}  // namespace gcslab
