#include "experiments/tasks/cover_task.h"

#include "covering/cover.h"
#include "enclosure/bound_registry.h"
#include "experiments/corpus/problem.h"
#include "experiments/corpus/problem_loader.h"
#include "experiments/tasks/bound_methods.h"
#include "experiments/tasks/job_result.h"
#include "experiments/tasks/stopwatch.h"

namespace gcslab {
namespace {

/// Trees of more cells are not handed to figures: no picture of a page shows them.
constexpr std::uint64_t kMaximumDrawnCells = 20'000'000;

CoverOptions cover_options(const Options& parameters) {
  return {static_cast<int>(parameters.integer("depth")), split_from_name(parameters.word("split"))};
}

Status status_of(const Cover& cover, Promise promise) {
  if (!cover.undecided.empty()) return Status::budget_exhausted;
  return promise == Promise::rigorous ? Status::complete : Status::partial;
}

}  // namespace

std::string CoverTask::summary() const {
  return "cells that cover an implicit curve, surface or space curve";
}

std::vector<MethodInfo> CoverTask::methods() const { return bound_methods(); }

std::vector<OptionSpec> CoverTask::parameters() const {
  return {integer_option("depth", "halvings of every variable", "", 8, 0, 30),
          choice_option("split", "halve all variables of a cell at once, or one after the other", "all",
                        {"all", "alternate"})};
}

std::vector<ValueInfo> CoverTask::values() const {
  return {{"kept_cells", "cells of the last level that may meet the set", "cells"},
          {"visited_cells", "cells that were bounded", "cells"},
          {"visited_per_level", "visited cells of each level, from the root", "cells"}};
}

std::vector<std::string> CoverTask::problem_kinds() const { return {"curve", "surface", "space_curve"}; }

void CoverTask::check(const Job& job) const {
  static_cast<void>(load_problem_of_kind(job.problem, problem_kinds()));
}

JobResult CoverTask::run(const Job& job, const std::stop_token& stop) const {
  const Problem problem = load_problem_of_kind(job.problem, problem_kinds());
  const Stopwatch preparation;
  const auto bounds = make_bounds(problem, job.method, job.options);
  JobResult result;
  result.timings["prepare_s"] = preparation.wall_s();
  const Stopwatch watch;
  const Cover found = cover(bounds, problem.system.box, cover_options(job.parameters), stop);
  result.timings["wall_s"] = watch.wall_s();
  result.timings["cpu_s"] = watch.cpu_s();
  result.status = status_of(found, bound_registry().at(job.method).promise(job.options));
  if (result.status == Status::budget_exhausted) {
    result.reason = "stopped with " + std::to_string(found.undecided.size()) + " boxes not looked at";
    return result;
  }
  result.values["kept_cells"] = found.tree.kept_cells();
  result.values["visited_cells"] = found.tree.visited_cells();
  result.values["visited_per_level"] = found.tree.visited_per_level();
  if (found.tree.visited_cells() <= kMaximumDrawnCells) result.artifact = found.tree.to_json();
  return result;
}

}  // namespace gcslab
