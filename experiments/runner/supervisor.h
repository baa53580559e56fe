#pragma once

// Runs jobs as child processes and names the outcome of each, whatever happens to it.

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "experiments/process/child_process.h"
#include "experiments/tasks/job_result.h"
#include "experiments/tasks/task.h"

namespace gcslab {

/// A job that has come to an end.
struct FinishedJob {
  Job job;
  JobResult result;
  double wall_s = 0;  ///< of the whole process
  double peak_rss_mb = 0;
  std::string started;  ///< UTC, ISO 8601
};

class Supervisor {
 public:
  /// Child processes find their question and leave their answer in `exchange`, a folder that exists.
  explicit Supervisor(std::filesystem::path exchange) : exchange_(std::move(exchange)) {}
  // Destruction kills what still runs.

  void start(const Job& job);
  std::size_t running() const { return children_.size(); }
  /// Waits at most 10 ms; the jobs that have ended meanwhile. Throws InputError when a child could not go on
  /// for a reason that would stop every other job too (disk full, problem file changed).
  std::vector<FinishedJob> wait();

 private:
  struct Child {
    Job job;
    std::filesystem::path question;
    std::filesystem::path answer;
    std::string started;
    std::unique_ptr<ChildProcess> process;
  };

  static FinishedJob finish(const Child& child);

  std::filesystem::path exchange_;
  std::vector<Child> children_;
};

}  // namespace gcslab
