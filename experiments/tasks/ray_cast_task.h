#pragma once

#include "experiments/tasks/task.h"

namespace gcslab {

/// Pictures of an implicit surface: along the ray of every pixel the equation is a polynomial in one
/// variable, of which the first root is what the eye sees (Tahari 2011, section 4.4.2). Methods are ways to
/// find that root; the figure kind `ray_panels` shows the pictures.
class RayCastTask final : public Task {
 public:
  std::string name() const override { return "ray_cast"; }
  std::string summary() const override;
  std::vector<MethodInfo> methods() const override;
  std::vector<OptionSpec> parameters() const override;
  std::vector<ValueInfo> values() const override;
  std::vector<std::string> problem_kinds() const override;
  void check(const Job& job) const override;
  JobResult run(const Job& job, const std::stop_token& stop) const override;
};

}  // namespace gcslab
