#pragma once

#include "experiments/tasks/task.h"

namespace gcslab {

/// One reduction of the box of a system by one contractor, as the number of unknowns grows: its time, its
/// memory (peak of the process) and how much it reduces. Methods are the registered contractors; problems are
/// families of systems. Every job also counts what the Bernstein polytope and the tensors of its system take.
class ReductionTask final : public Task {
 public:
  std::string name() const override { return "reduction"; }
  std::string summary() const override;
  std::vector<MethodInfo> methods() const override;
  std::vector<OptionSpec> parameters() const override;
  std::vector<ValueInfo> values() const override;
  std::vector<std::string> problem_kinds() const override;
  void check(const Job& job) const override;
  JobResult run(const Job& job, const std::stop_token& stop) const override;
};

}  // namespace gcslab
