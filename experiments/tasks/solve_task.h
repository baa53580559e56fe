#pragma once

#include "experiments/tasks/task.h"

namespace gcslab {

/// Finds every real solution of a system in its box; methods are settings of the branch-and-prune engine.
class SolveTask final : public Task {
 public:
  std::string name() const override { return "solve"; }
  std::string summary() const override;
  std::vector<MethodInfo> methods() const override;
  std::vector<OptionSpec> parameters() const override;
  std::vector<ValueInfo> values() const override;
  std::vector<std::string> problem_kinds() const override;
  void check(const Job& job) const override;
  JobResult run(const Job& job, const std::stop_token& stop) const override;
};

}  // namespace gcslab
