#pragma once

// All that an experiment can name: tasks with their methods, problems of the corpus, forms of reports.

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "base/registry.h"
#include "experiments/tasks/task.h"

namespace gcslab {

struct ReportItem;

struct TaskEntry {
  explicit TaskEntry(std::shared_ptr<const Task> a_task) : name(a_task->name()), task(std::move(a_task)) {}

  std::string name;
  std::shared_ptr<const Task> task;
};

using TaskRegistry = Registry<TaskEntry>;

/// Where problems come from.
struct ProblemSource {
  /// The names that a config's entry stands for: itself, or the members of "suite:NAME". Throws InputError,
  /// with the nearest name, when there is no such problem.
  std::function<std::vector<std::string>(const std::string& entry)> expand;
  /// A hash of all that the problem's mathematical content follows from.
  std::function<std::string(const std::string& name)> content_hash;
};

struct Catalogue {
  const TaskRegistry& tasks;
  ProblemSource problems;
  /// Throws InputError when a table or figure of a config cannot be made (unknown kind, unknown option). Not
  /// called when empty: then only the names of axes and values are checked.
  std::function<void(const ReportItem&)> check_report_item{};
};

}  // namespace gcslab
