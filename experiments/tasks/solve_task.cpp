#include "experiments/tasks/solve_task.h"

#include <algorithm>
#include <cmath>

#include "experiments/corpus/problem_loader.h"
#include "experiments/solving/figure_picture.h"
#include "experiments/solving/result_json.h"
#include "experiments/solving/search_picture_json.h"
#include "experiments/solving/sketch_source.h"
#include "experiments/solving/solve_method.h"
#include "experiments/tasks/job_result.h"
#include "experiments/tasks/packing_drawing.h"
#include "experiments/tasks/stopwatch.h"
#include "geometry/congruence.h"
#include "geometry/sketch.h"

namespace gcslab {

namespace {

bool can_be_drawn(const Box& box) {
  return (box.size() == 2 || box.size() == 3) && std::ranges::all_of(box, is_bounded);
}

std::ptrdiff_t number_of(const SearchResult& found, Claim claim) {
  return std::ranges::count(found.solutions, claim, &Solution::claim);
}

void add_values(const Problem& problem, const SystemFunctions& functions, const SolveOutcome& found,
                JobResult& result) {
  result.values["solutions"] = number_of(found.search, Claim::unique);
  result.values["existing"] = number_of(found.search, Claim::exists);
  result.values["unproved"] = number_of(found.search, Claim::none);
  if (problem.known.real_solutions) result.values["known_solutions"] = *problem.known.real_solutions;
  result.values["unknowns"] = functions.variables();
  result.values["undecided"] = found.search.undecided.size();
  if (found.status == Status::budget_exhausted) return;  // the counts would depend on the machine
  if (found.steps) result.values["steps"] = *found.steps;
  result.values["boxes"] = found.search.statistics.boxes;
  result.values["bisections"] = found.search.statistics.bisections;
}

void tell_recorded(const SearchRecord& record, JobResult& result) {
  if (!record.is_whole()) return;
  int reductions = 0;
  for (const RecordedBox& box : record.boxes()) reductions += box.reductions;
  result.values["reductions"] = reductions;
  result.values["empty_boxes"] = std::ranges::count(record.boxes(), BoxFate::empty, &RecordedBox::fate);
}

void add_class_values(const FigurePicture& picture, JobResult& result) {
  const auto is_regular = [](const PicturedFigure& figure) { return figure.is_certified; };
  const auto regular = std::ranges::count_if(picture.figures, is_regular);
  result.values["classes"] = picture.figures.size();
  result.values["regular_classes"] = regular;
  result.values["singular_classes"] = std::ssize(picture.figures) - regular;
  result.values["flat_classes"] = std::ranges::count_if(
      picture.figures, [](const PicturedFigure& figure) { return is_flat(figure.places); });
}

void add_path_values(const Path& path, JobResult& result) {
  result.values["crossings"] = path.crossings.size();
  result.values["path_type"] = std::string(name_of(path.end));
  result.values["other_end"] = std::string(name_of(path.other_end));
  result.values["refused_steps"] = path.refused;
  result.values["restarts"] = path.restarts;
  result.values["critical_points"] = path.branch_points.size();
  if (path.tubes == 0) return;
  result.values["tubes"] = path.tubes;
  result.values["unproved_steps"] = path.unproved_steps;
  result.values["return_proved"] = path.is_return_proved ? 1 : 0;
}

void add_plan_values(const PlanReport& plan, JobResult& result) {
  result.values["guides"] = plan.guides;
  result.values["choices"] = plan.choices;
  if (plan.sketches) result.values["sketches"] = *plan.sketches;
  if (plan.plans) result.values["plans"] = *plan.plans;
  if (plan.plan_changes) result.values["plan_changes"] = *plan.plan_changes;
  if (plan.branch_changes) result.values["branch_changes"] = *plan.branch_changes;
  // Rounded: the length of a path is a sum of doubles, and values are compared exactly.
  if (plan.simplices_per_edge)
    result.values["simplices_per_edge"] = std::round(1000 * *plan.simplices_per_edge) / 1000;
}

bool has_option(const Options& options, const std::string& name) { return options.values().contains(name); }

/// What a constraint system's row shows: figures up to isometry, the sketch of methods that have one, and the
/// path where it was traced.
void add_geometry(const SolveSettings& settings, const SolveOutcome& found, JobResult& result) {
  const GeometricSource& source = *settings.geometry;
  FigurePicture picture = figure_picture(source, found.search);
  add_class_values(picture, result);
  if (has_option(settings.options, "random_sketch"))
    picture.sketch = in_frame(source.system, source.frame, sketch_source(settings).sketch);
  if (found.plan) {
    for (const PlanReport::NewFigure& sketch : found.plan->new_sketches) {
      if (is_frame_flat(source.frame, sketch.figure)) continue;
      picture.new_sketches.push_back(
          {sketch.origin, reflected_upright(in_frame(source.system, source.frame, sketch.figure),
                                            source.equations.sorts, source.frame)});
    }
  }
  result.artifact = to_json(picture);
  if (found.plan) {
    add_plan_values(*found.plan, result);
    result.artifact["plan"] = to_json(found.plan->diagram);
  }
  if (!found.paths.empty()) result.values["paths"] = found.paths.size();
  if (found.paths.size() != 1) return;  // of many, only their number
  const FollowedPath& followed = found.paths.front();
  add_path_values(followed.found.path, result);
  if (followed.step_s) result.timings["step_s"] = *followed.step_s;
  if (followed.trace) result.artifact["path"] = to_json(*followed.trace);
}

}  // namespace

std::string SolveTask::summary() const { return "every real solution of a system in its box, with proof"; }

std::vector<MethodInfo> SolveTask::methods() const {
  std::vector<MethodInfo> methods;
  for (const SolveMethod& method : solve_method_registry().entries()) {
    methods.push_back(
        {method.name, method.summary, method.promise, method.version, method.options, method.promise_with});
  }
  return methods;
}

std::vector<OptionSpec> SolveTask::parameters() const {
  return {
      integer_option("threads", "threads of the search; the answer does not depend on them", "", 1, 1, 256),
      integer_option("recorded_boxes",
                     "boxes of a search in two or three unknowns that are kept for figures, in the order "
                     "taken; 0: none, and no time spent on it",
                     "boxes", 0, 0, 100'000),
      integer_option("traced_points",
                     "points of a path that are kept for figures, at most; 0: none, and no time spent on it",
                     "points", 0, 0, 100'000),
      choice_option(
          "sketch",
          "from which a method of constraint systems sets out, unless its option random_sketch says: "
          "the problem's own, or a random one, drawn by the seed of the job",
          "own", {"own", "random"})};
}

std::vector<ValueInfo> SolveTask::values() const {
  return {
      {"solutions", "certified solutions, each alone in its box", "solutions"},
      {"existing", "boxes proved to contain a solution, single or not", "boxes"},
      {"unproved", "solutions that plain doubles found, here or elsewhere, without certificate", "solutions"},
      {"known_solutions", "solutions in the box that are known by other means", "solutions"},
      {"unknowns", "variables of the system", "variables"},
      {"undecided", "boxes that may hold a solution, with nothing proved", "boxes"},
      {"boxes", "boxes taken from the list", "boxes"},
      {"bisections", "boxes cut in two", "boxes"},
      {"steps", "of all paths, simplices of a path, or evaluations of a search", "steps"},
      {"classes", "figures found, up to isometry, of a constraint system", "figures"},
      {"regular_classes", "classes with a certified solution", "figures"},
      {"singular_classes", "classes without one, as on continua of solutions", "figures"},
      {"flat_classes", "classes of space with all points in a plane", "figures"},
      {"crossings", "of t = 1 by a path", "crossings"},
      {"paths", "that were followed", "paths"},
      {"guides", "distances that a construction plan needs to be given", "guides"},
      {"choices", "steps of a construction plan with two places", "choices"},
      {"sketches", "that the branches of a plan gave, the user's included", "sketches"},
      {"plans", "that were made, where a path goes through several", "plans"},
      {"plan_changes", "of a path from one plan to another", "changes"},
      {"branch_changes", "of a path from one branch of a plan to another", "changes"},
      {"simplices_per_edge", "simplices on a path as long as one of their edges along an axis, in the mean",
       "simplices"},
      {"step_s", "median wall time of a step of a path", "s"},
      {"path_type", "how a path ended: cycle, to_infinity, to_undefined, budget"},
      {"other_end", "the same of its other direction"},
      {"refused_steps", "steps of a path that were tried in vain", "steps"},
      {"restarts", "of a path with smaller steps, after jumps that were noticed", "restarts"},
      {"critical_points", "points of a path at which branches cross", "points"},
      {"tubes", "of the proof that a path stays on one curve", "tubes"},
      {"unproved_steps", "across critical points, of which that proof says nothing", "steps"},
      {"return_proved", "1: the tubes lead back to the sketch"},
      {"reductions", "rounds of contraction that narrowed a box or emptied it, where all were recorded"},
      {"empty_boxes", "boxes proved to have no root, where all were recorded", "boxes"}};
}

std::vector<std::string> SolveTask::problem_kinds() const { return system_kinds(); }

void SolveTask::check(const Job& job) const {
  static_cast<void>(load_system(job.problem, job.options.word("valuation")));
}

JobResult SolveTask::run(const Job& job, const std::stop_token& stop) const {
  const Problem problem = load_system(job.problem, job.options.word("valuation"));
  const Stopwatch preparation;
  const SystemFunctions functions(problem.system);
  SolveSettings settings{job.method, job.options};
  settings.threads = static_cast<int>(job.parameters.integer("threads"));
  SearchRecord record(static_cast<std::size_t>(job.parameters.integer("recorded_boxes")));
  const bool is_recorded =
      job.parameters.integer("recorded_boxes") > 0 && can_be_drawn(functions.system().box);
  if (is_recorded) settings.record = &record;
  settings.geometry = problem.geometry.get();
  settings.traced_points = static_cast<std::size_t>(job.parameters.integer("traced_points"));
  if (job.parameters.word("sketch") == "random") settings.sketch_seed = job.seed;
  JobResult result;
  result.timings["prepare_s"] = preparation.wall_s();
  const Stopwatch watch;
  const SolveOutcome found = solve_system(functions, settings, std::nullopt, stop);
  result.timings["wall_s"] = watch.wall_s();
  result.timings["cpu_s"] = watch.cpu_s();
  result.status = found.status;
  result.reason = found.reason;
  if (result.reason.empty() && found.status == Status::budget_exhausted)
    result.reason = "boxes were left when the budget ended";
  if (found.status == Status::not_applicable || found.status == Status::failed) return result;
  add_values(problem, functions, found, result);
  if (found.status == Status::budget_exhausted) return result;
  if (problem.geometry != nullptr) {
    add_geometry(settings, found, result);
  } else {
    result.artifact = packing_drawing(problem.name, functions, found.search);
  }
  if (is_recorded) {
    tell_recorded(record, result);
    result.artifact = to_json(search_picture(functions.system().box, record, found.search));
  }
  return result;
}

}  // namespace gcslab
