#pragma once

#include "experiments/tasks/task.h"

namespace gcslab {

/// The linear programs of boxes that a search of a system met, solved again: what one reduction costs by a
/// solver of linear programs, whether its bounds are right, and what it costs to make them rigorous. The
/// boxes are those that hull consistency and multipliers leave, evenly spaced over the search, and the same
/// for every method.
class ReplayTask final : public Task {
 public:
  std::string name() const override { return "replay"; }
  std::string summary() const override;
  std::vector<MethodInfo> methods() const override;
  std::vector<OptionSpec> parameters() const override;
  std::vector<ValueInfo> values() const override;
  std::vector<std::string> problem_kinds() const override;
  void check(const Job& job) const override;
  JobResult run(const Job& job, const std::stop_token& stop) const override;
};

}  // namespace gcslab
