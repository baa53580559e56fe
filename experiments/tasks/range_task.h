#pragma once

#include "experiments/tasks/task.h"

namespace gcslab {

/// Bounds the range of one function over its box; methods are the registered range bounds. The function is
/// one of the corpus, or a random polynomial of a family with the degree and dimension that the parameters
/// say.
class RangeTask final : public Task {
 public:
  std::string name() const override { return "range"; }
  std::string summary() const override;
  std::vector<MethodInfo> methods() const override;
  std::vector<OptionSpec> parameters() const override;
  std::vector<ValueInfo> values() const override;
  std::vector<std::string> problem_kinds() const override;
  void check(const Job& job) const override;
  JobResult run(const Job& job, const std::stop_token& stop) const override;
};

}  // namespace gcslab
