#pragma once

#include "experiments/tasks/task.h"

namespace gcslab {

/// How much a conversion from powers to the Bernstein basis loses in an arithmetic, as the degree grows. A
/// random polynomial is given by Bernstein coefficients; its power coefficients, computed exactly and rounded
/// to the arithmetic, are converted back in it. Methods are number types.
class ConversionTask final : public Task {
 public:
  std::string name() const override { return "conversion"; }
  std::string summary() const override;
  std::vector<MethodInfo> methods() const override;
  std::vector<OptionSpec> parameters() const override;
  std::vector<ValueInfo> values() const override;
  std::vector<std::string> problem_kinds() const override { return {"bernstein_family"}; }
  void check(const Job& job) const override;
  JobResult run(const Job& job, const std::stop_token& stop) const override;
};

}  // namespace gcslab
