// Methods that construct the figures of a constraint system by a plan.

#include <algorithm>
#include <fmt/format.h>
#include <functional>

#include "base/error.h"
#include "certification/root_certifier.h"
#include "construction/exploration.h"
#include "construction/plan_atlas.h"
#include "construction/plan_escapes.h"
#include "construction/plan_homotopy.h"
#include "construction/plan_newton.h"
#include "construction/plan_simplices.h"
#include "construction/plan_singularity.h"
#include "experiments/solving/path_settings.h"
#include "experiments/solving/plan_report.h"
#include "experiments/solving/sketch_source.h"
#include "geometry/degrees_of_freedom.h"
#include "geometry/sketch.h"
#include "homotopy/level_crossing.h"

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

/// The configurations of the plan that the ends of a path at infinity meet.
void note_escapes(FollowedPath& followed, const Plan& plan, const PlanSource& given, const FigureCurve& curve,
                  double extent) {
  constexpr double kFar = 1e2;  // as for where paths are stuck (homotopy/path_explanation.h)
  const std::vector<PlanEscape> escapes = escapes_of(plan, given.system);
  const auto met = [&](PathEnd end, const std::vector<double>& last) -> std::string {
    if (end != PathEnd::to_infinity || last.empty()) return "";
    const Figure figure = figure_at(given.equations, curve.unknowns(last));
    return escape_met(escapes, plan, given.system, figure, kFar * extent);
  };
  const Path& path = followed.found.path;
  followed.escape = met(path.end, path.last);
  followed.other_escape = met(path.other_end, path.other_last);
}

/// Where instructions of the plan have no point of their own, and where the frame of the system holds no
/// figure.
void note_events(FollowedPath& followed, const PlanHomotopy& homotopy, const PlanSource& given) {
  constexpr double kSingular = 1e-3;
  const Path& path = followed.found.path;
  const PlanProgram& program = homotopy.program();
  const auto figure_of = [&](const std::vector<double>& v) {
    return figure_at(given.equations, homotopy.curve().unknowns(v));
  };
  const auto line_text = [&](const char* whose, const Frame& frame) {
    std::string names;
    for (const std::size_t point : frame) names += " " + given.system.objects[point].name;
    return fmt::format("the points of the {}frame,{}, are on a line", whose, names);
  };
  const Frame& frame = given.source.geometry.frame;
  const Frame plan_frame = program.plan().frame(given.system.universe);
  const auto event = [&](PathEnd end, const std::vector<double>& last) -> std::string {
    if ((end != PathEnd::stuck && end != PathEnd::to_undefined) || last.empty()) return "";
    const Figure figure = figure_of(last);
    if (is_frame_flat(plan_frame, figure) || frame_height(plan_frame, figure) < kSingular)
      return line_text("plan's ", plan_frame);
    const auto least = least_general_step(program, in_frame(given.system, plan_frame, figure), given.wanted);
    std::string text = is_frame_flat(frame, figure) ? line_text("", frame) : "";
    if (!least || !(least->sine < kSingular)) return text;
    const std::string& name = given.system.objects[program.steps()[least->step].point].name;
    return text + (text.empty() ? "" : "; ") + "the plan is singular at " + name +
           ", whose loci are not in general position";
  };
  followed.plan_event = event(path.end, path.last);
  followed.other_plan_event = event(path.other_end, path.other_last);
  for (const Crossing& crossing : path.crossings) {
    const bool is_flat = is_frame_flat(frame, figure_of(crossing.v));
    followed.crossing_events.push_back(is_flat ? line_text("", frame) : "");
  }
}

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
  note_escapes(followed, homotopy.program().plan(), given, curve, sketched.extent());
  note_events(followed, homotopy, given);
  SolveOutcome outcome = outcome_of(std::move(followed), false);
  outcome.plan = report_with_escapes(homotopy.program().plan(), given.system);
  return outcome;
}

/// What a trace notes, in coordinates that depend on no plan.
PathObserver chartless(const PlanAtlas& atlas, PathObserver observer) {
  if (!observer) return observer;
  const auto shown = [&atlas](const CurvePoint& point) {
    constexpr double kAhead = 1e-6;
    std::vector<double> ahead = point.v;
    for (std::size_t i = 0; i < ahead.size(); ++i) ahead[i] += kAhead * point.tangent[i];
    CurvePoint result{atlas.chartless(point.v), atlas.chartless(ahead), point.orientation};
    for (std::size_t i = 0; i < result.v.size(); ++i) result.tangent[i] -= result.v[i];
    const double length = norm(result.tangent);
    for (double& x : result.tangent) x /= length;
    return result;
  };
  return [shown, observer = std::move(observer)](PathState state) {
    state.here = shown(state.here);
    if (state.before) state.before = shown(*state.before);
    observer(state);
  };
}

SolveOutcome solve_along_plans(const SystemFunctions& functions, const SolveSettings& settings,
                               const std::optional<SearchStart>&, const std::stop_token& stop,
                               SearchObserver*) {
  const PlanSource given(functions, settings);
  const Options& options = settings.options;
  const Frame& frame = given.source.geometry.frame;
  SketchHomotopy sketched(given.system, frame, given.equations, given.wanted, given.source.sketch,
                          homotopy_options(options));
  Homotopy& figures = sketched.curve();
  PlanAtlas atlas(given.system, frame, given.equations, sketched, plan_kind(options));
  Tracer tracer(settings, figures, given.equations);
  Path path = follow_path(atlas, atlas.begin(), tracker_options(options, sketched.extent() / sketched.unit()),
                          stop, {.observer = chartless(atlas, tracer.observer()), .charts = &atlas});
  FollowedPath followed{solutions_of(std::move(path), figures, functions, options.word("certifier")), {}};
  followed.trace = tracer.traced(followed.found.path, sketched.start(), false);
  followed.explanation =
      explain(followed.found.path, given.system, given.equations, figures, sketched.extent());
  const Plan& first = atlas.first().program().plan();
  note_escapes(followed, first, given, figures, sketched.extent());
  const std::uint64_t changes = followed.found.path.chart_changes;
  SolveOutcome outcome = outcome_of(std::move(followed), false);
  outcome.plan = report_with_escapes(first, given.system);
  outcome.plan->plans = atlas.plans();
  outcome.plan->plan_changes = changes;
  return outcome;
}

/// The point of the plan's curve with these guides, over the unit, on the branch, at t = 1, polished.
Crossing crossing_at(BranchMap& map, PlanCurve& curve, const std::vector<double>& guides,
                     const Branch& branch, double length) {
  std::vector<double> v = guides, values(map.guides());
  v.push_back(1);
  map.values(branch, v, values);
  v.pop_back();
  for (const double height : map.heights()) v.push_back(height / map.unit());
  v.push_back(1);
  solve_at_level(curve, v);
  const std::size_t rank = rank_at(curve, v);
  return {std::move(v), length, rank};
}

/// What the methods on branches work with.
struct Branched {
  Branched(const PlanSource& given, const Options& options)
      : sketched(given.system, given.source.geometry.frame, given.equations, given.wanted,
                 given.source.sketch, homotopy_options(options)),
        homotopy(given.system, given.source.geometry.frame, given.equations, sketched, plan_kind(options)),
        map(homotopy.motion()) {
    if (map.guides() == 0)
      throw NotApplicable(
          "the construction plan needs no guide parameters: plan_evaluation lists all solutions");
  }

  SketchHomotopy sketched;
  PlanHomotopy homotopy;
  BranchMap map;
};

SolveOutcome follow_branches(const SystemFunctions& functions, const SolveSettings& settings,
                             const std::optional<SearchStart>&, const std::stop_token& stop,
                             SearchObserver*) {
  const PlanSource given(functions, settings);
  const Options& options = settings.options;
  Branched branched(given, options);
  PlanCurve& curve = branched.homotopy.curve();
  const double extent = branched.sketched.extent();
  const bool is_to_first_crossing = options.word("until") == "first_crossing";
  const PlanSimplexPath found = follow_plan_simplices(
      branched.map, branched.homotopy.start(),
      {options.real("mesh"), options.real("infinity") * extent / branched.sketched.unit(),
       static_cast<std::uint64_t>(options.integer("maximum_simplices")), is_to_first_crossing},
      stop);
  Path path;
  path.end = found.end;
  path.other_end = found.other_end;
  path.length = found.length;
  path.steps = found.simplices;
  for (const BranchCrossing& crossing : found.crossings) {
    std::vector<double> guides = crossing.v;
    guides.pop_back();
    path.crossings.push_back(crossing_at(branched.map, curve, guides, crossing.branch, crossing.length));
  }
  FollowedPath followed{solutions_of(std::move(path), curve, functions, options.word("certifier")), {}};
  followed.explanation.end = followed.explanation.other_end = found.failure;
  SolveOutcome outcome = outcome_of(std::move(followed), is_to_first_crossing);
  outcome.plan = report_with_escapes(branched.homotopy.program().plan(), given.system);
  outcome.plan->branch_changes = found.changes.size();
  if (found.length > 0)
    outcome.plan->simplices_per_edge =
        static_cast<double>(found.simplices) * options.real("mesh") / found.length;
  return outcome;
}

SolveOutcome search_branches(const SystemFunctions& functions, const SolveSettings& settings,
                             const std::function<BranchSearch(const PlanSource&, Branched&)>& search) {
  const PlanSource given(functions, settings);
  Branched branched(given, settings.options);
  PlanCurve& curve = branched.homotopy.curve();
  const BranchSearch found = search(given, branched);
  Path path;
  for (const BranchSolution& solution : found.solutions)
    path.crossings.push_back(crossing_at(branched.map, curve, solution.guides, solution.branch, 0));
  const SketchSolutions listed =
      solutions_of(std::move(path), curve, functions, settings.options.word("certifier"));
  SolveOutcome outcome;
  for (const SketchSolution& solution : listed.solutions)
    outcome.search.solutions.push_back(found_solution(solution.unknowns, solution.root));
  outcome.status = Status::partial;
  outcome.steps = found.evaluations;
  outcome.plan = report_of(branched.homotopy.program().plan(), given.system);
  if (listed.solutions.empty()) {
    std::string missing;
    for (const PlanStep& step : branched.homotopy.program().plan().steps) {
      if (step.choice && found.negative.contains(*step.choice))
        missing += (missing.empty() ? "" : ", ") + given.system.objects[step.point].name;
    }
    outcome.reason = fmt::format(
        "no solution: {} branches never inside of their domain{}, {} stopped at its border or a minimum, {} "
        "unfinished",
        found.outside, missing.empty() ? "" : fmt::format(" (the loci of {} do not meet)", missing),
        found.stuck, found.unfinished);
  }
  return outcome;
}

SolveOutcome newton_in_guides(const SystemFunctions& functions, const SolveSettings& settings,
                              const std::optional<SearchStart>&, const std::stop_token&, SearchObserver*) {
  return search_branches(functions, settings, [](const PlanSource&, Branched& branched) {
    std::vector<double> guides = branched.homotopy.start().guides;
    for (double& guide : guides) guide /= branched.map.unit();
    return newton_on_branches(branched.map, guides);
  });
}

SolveOutcome sampled_guide(const SystemFunctions& functions, const SolveSettings& settings,
                           const std::optional<SearchStart>&, const std::stop_token&, SearchObserver*) {
  const auto samples = static_cast<std::size_t>(settings.options.integer("samples"));
  return search_branches(functions, settings, [samples](const PlanSource& given, Branched& branched) {
    double largest = 0;  // no distance is more than all that are given
    for (const Constraint& constraint : given.system.constraints) {
      if (constraint.kind->name == "distance") largest += given.wanted[*constraint.parameter];
    }
    return sample_branches(branched.map, largest / branched.map.unit(), samples);
  });
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
  std::vector<PlanReport::NewFigure> of_the_first;
  for (ExploredPath& path : found.paths) {
    if (path.sketch.solution == 0U)
      of_the_first.push_back({"branch " + text_of(path.sketch.branch), path.sketch.figure});
    *outcome.steps += path.found.path.steps;
    FollowedPath followed{std::move(path.found), std::move(path.explanation), std::move(path.numbers)};
    followed.escape = std::move(path.escape);
    followed.other_escape = std::move(path.other_escape);
    if (path.sketch.solution)
      followed.origin =
          fmt::format("class {}, branch {}", *path.sketch.solution, text_of(path.sketch.branch));
    if (path.refused.empty()) outcome.paths.push_back(std::move(followed));
  }
  outcome.plan = report_with_escapes(found.plan, given.system);
  outcome.plan->sketches = found.sketches;
  if (found.unread > 0) outcome.plan->unread = found.unread;
  outcome.plan->new_sketches = std::move(of_the_first);
  return outcome;
}

std::vector<OptionSpec> branch_options(const std::vector<OptionSpec>& own) {
  std::vector<OptionSpec> specs = {plan_option("least")};
  const auto add = [&](const std::vector<OptionSpec>& more) {
    specs.insert(specs.end(), more.begin(), more.end());
  };
  add(own);
  add(homotopy_option_specs());
  add({random_sketch_option(), certifier_option()});
  return specs;
}

std::vector<OptionSpec> shared_options(const std::string& plan, const std::vector<OptionSpec>& own) {
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
  const auto method = [](std::string name, std::string summary, std::vector<OptionSpec> options, auto solve,
                         std::string no_search, bool follows_path = false) {
    return SolveMethod{std::move(name), std::move(summary), 4,  std::move(options),
                       solve,           Promise::rigorous,  {}, std::move(no_search),
                       follows_path};
  };
  return {
      method("plan_path",
             "constraint systems: the homotopy path of the sketch in the guide parameters and heights of a "
             "construction plan (after Gao, Hoffmann, Yang 2004 and Imbach 2013)",
             shared_options("least", {}), solve_along_plan, "follows a path", true),
      method("plan_path_adaptive",
             "the same, going on in another plan where one becomes singular (after Imbach, Mathis, Schreck "
             "2017)",
             shared_options("least", {}), solve_along_plans, "follows a path"),
      method(
          "plan_pli",
          "the same path in the guide parameters alone, through simplices, from branch to branch of the plan "
          "(Imbach 2013, section 4.3)",
          branch_options({real_option("mesh", "edges of the simplices along the axes",
                                      "in sizes of the sketch and t", 1e-2, 1e-9, 1),
                          choice_option("until", "where the path is left", "end", {"end", "first_crossing"}),
                          real_option("infinity", "where a path is given up as going there",
                                      "sizes of the sketch", 1e5, 10, 1e12),
                          integer_option("maximum_simplices", "work budget", "simplices", 10'000'000, 1,
                                         1'000'000'000)}),
          follow_branches, "follows a path"),
      method("plan_newton",
             "constraint systems: Newton's iteration for the guide parameters of a construction plan, on "
             "each branch, "
             "inside of its domain (Fabre, Schreck 2008)",
             branch_options({}), newton_in_guides, "searches locally"),
      method("plan_sampling",
             "constraint systems: the guide parameter of a construction plan sampled on each branch, changes "
             "of sign "
             "bisected (Gao, Hoffmann, Yang 2004)",
             branch_options({integer_option("samples", "of each branch", "intervals", 1000, 1, 100'000'000)}),
             sampled_guide, "searches locally"),
      method("plan_exploration",
             "constraint systems: new sketches from every solution by the branches of a construction plan, "
             "and the "
             "path of each, until nothing new is found; a solution a class (Imbach 2013)",
             shared_options(
                 "least", {integer_option("maximum_paths", "work budget", "paths", 100'000, 1, 1'000'000'000),
                           OptionSpec{"sketches", "branches whose sketches are followed, as +-+/++-, or all",
                                      std::string("all")}}),
             explore_sketches, "follows paths")};
}

}  // namespace gcslab
