#include "experiments/tasks/solve_task.h"

#include "experiments/corpus/problem_loader.h"
#include "experiments/solving/result_json.h"
#include "experiments/solving/solve_method.h"
#include "experiments/tasks/job_result.h"
#include "experiments/tasks/packing_drawing.h"
#include "experiments/tasks/stopwatch.h"

namespace gcslab {

std::string SolveTask::summary() const { return "every real solution of a system in its box, with proof"; }

std::vector<MethodInfo> SolveTask::methods() const {
  std::vector<MethodInfo> methods;
  for (const SolveMethod& method : solve_method_registry().entries()) {
    methods.push_back({method.name, method.summary, Promise::rigorous, method.version, method.options});
  }
  return methods;
}

std::vector<OptionSpec> SolveTask::parameters() const {
  return {
      integer_option("threads", "threads of the search; the answer does not depend on them", "", 1, 1, 256)};
}

std::vector<ValueInfo> SolveTask::values() const {
  return {{"solutions", "certified solutions", "solutions"},
          {"known_solutions", "solutions in the box that are known by other means", "solutions"},
          {"unknowns", "variables of the system", "variables"},
          {"undecided", "boxes that may hold a solution, with nothing proved", "boxes"},
          {"boxes", "boxes taken from the list", "boxes"},
          {"bisections", "boxes cut in two", "boxes"}};
}

std::vector<std::string> SolveTask::problem_kinds() const { return system_kinds(); }

void SolveTask::check(const Job& job) const { static_cast<void>(load_system(job.problem)); }

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
  if (found.status == Status::budget_exhausted) result.reason = "boxes were left when the budget ended";
  result.values["solutions"] = found.search.solutions.size();
  if (problem.known.real_solutions) result.values["known_solutions"] = *problem.known.real_solutions;
  result.values["unknowns"] = functions.variables();
  result.values["undecided"] = found.search.undecided.size();
  if (found.status == Status::budget_exhausted) return result;  // the counts would depend on the machine
  result.artifact = packing_drawing(problem.name, functions, found.search);
  result.values["boxes"] = found.search.statistics.boxes;
  result.values["bisections"] = found.search.statistics.bisections;
  return result;
}

}  // namespace gcslab
