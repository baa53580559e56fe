#include "experiments/tasks/solve_task.h"

#include <algorithm>

#include "experiments/corpus/problem_loader.h"
#include "experiments/solving/result_json.h"
#include "experiments/solving/solve_run.h"
#include "experiments/solving/system_methods.h"
#include "experiments/tasks/job_result.h"
#include "experiments/tasks/stopwatch.h"

namespace gcslab {

std::string SolveTask::summary() const { return "every real solution of a system in its box, with proof"; }

std::vector<MethodInfo> SolveTask::methods() const {
  std::vector<MethodInfo> methods;
  for (const SystemMethod& method : system_method_registry().entries())
    methods.push_back({method.name, method.summary, method.promise, method.version, method.options});
  return methods;
}

std::vector<OptionSpec> SolveTask::parameters() const {
  return {
      integer_option("threads", "threads of the search; the answer does not depend on them", "", 1, 1, 256)};
}

std::vector<ValueInfo> SolveTask::values() const {
  return {{"solutions", "certified solutions, each alone in its box", "solutions"},
          {"existing", "boxes proved to contain a solution, single or not", "boxes"},
          {"unproved", "solutions that a program of others found, without certificate", "solutions"},
          {"known_solutions", "solutions in the box that are known by other means", "solutions"},
          {"undecided", "boxes that may hold a solution, with nothing proved", "boxes"},
          {"boxes", "boxes taken from the list", "boxes"},
          {"bisections", "boxes cut in two", "boxes"}};
}

std::vector<std::string> SolveTask::problem_kinds() const { return system_kinds(); }

void SolveTask::check(const Job& job) const { static_cast<void>(load_system(job.problem)); }

namespace {

std::ptrdiff_t number_of(const SearchResult& found, Claim claim) {
  return std::ranges::count(found.solutions, claim, &Solution::claim);
}

void add_values(const Problem& problem, const SolveOutcome& found, JobResult& result) {
  result.values["solutions"] = number_of(found.search, Claim::unique);
  result.values["existing"] = number_of(found.search, Claim::exists);
  result.values["unproved"] = number_of(found.search, Claim::none);
  if (problem.known.real_solutions) result.values["known_solutions"] = *problem.known.real_solutions;
  result.values["undecided"] = found.search.undecided.size();
  if (found.status == Status::budget_exhausted) return;  // the counts would depend on the machine
  result.values["boxes"] = found.search.statistics.boxes;
  result.values["bisections"] = found.search.statistics.bisections;
}

}  // namespace

JobResult SolveTask::run(const Job& job, const std::stop_token& stop) const {
  const Problem problem = load_system(job.problem);
  const Stopwatch preparation;
  const SystemFunctions functions(problem.system);
  SolveSettings settings{job.method, job.options};
  settings.threads = static_cast<int>(job.parameters.integer("threads"));
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
  add_values(problem, found, result);
  return result;
}

}  // namespace gcslab
