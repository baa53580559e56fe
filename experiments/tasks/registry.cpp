#include "experiments/tasks/registry.h"

#include "experiments/corpus/corpus.h"
#include "experiments/corpus/problem.h"
#include "experiments/tasks/conversion_task.h"
#include "experiments/tasks/cover_task.h"
#include "experiments/tasks/illustrate_task.h"
#include "experiments/tasks/range_task.h"
#include "experiments/tasks/ray_cast_task.h"
#include "experiments/tasks/reduction_task.h"
#include "experiments/tasks/replay_task.h"
#include "experiments/tasks/solve_task.h"

namespace gcslab {

// A new task is one line here.
const TaskRegistry& task_registry() {
  static const TaskRegistry registry("task", {
                                                 TaskEntry(std::make_shared<CoverTask>()),
                                                 TaskEntry(std::make_shared<SolveTask>()),
                                                 TaskEntry(std::make_shared<RangeTask>()),
                                                 TaskEntry(std::make_shared<ConversionTask>()),
                                                 TaskEntry(std::make_shared<IllustrateTask>()),
                                                 TaskEntry(std::make_shared<ReductionTask>()),
                                                 TaskEntry(std::make_shared<ReplayTask>()),
                                                 TaskEntry(std::make_shared<RayCastTask>()),
                                             });
  return registry;
}

Catalogue standard_catalogue() {
  return {
      task_registry(),
      {[](const std::string& entry) { return Corpus::standard().expand(entry); },
       [](const std::string& name) { return problem_content_hash(Corpus::standard().problem_path(name)); }}};
}

}  // namespace gcslab
