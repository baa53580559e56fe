#pragma once

#include "experiments/tasks/task.h"

namespace gcslab {

/// Covers an implicit curve, surface or space curve by cells; methods are the registered range bounds.
class CoverTask final : public Task {
 public:
  std::string name() const override { return "cover"; }
  std::string summary() const override;
  std::vector<MethodInfo> methods() const override;
  std::vector<OptionSpec> parameters() const override;
  std::vector<ValueInfo> values() const override;
  std::vector<std::string> problem_kinds() const override;
  void check(const Job& job) const override;
  JobResult run(const Job& job, const std::stop_token& stop) const override;
};

}  // namespace gcslab
