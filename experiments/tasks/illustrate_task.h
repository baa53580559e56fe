#pragma once

#include <filesystem>

#include "experiments/tasks/task.h"

namespace gcslab {

/// Drawings of the mathematics itself: Bernstein polynomials, de Casteljau's algorithm. Methods are drawings;
/// the figure kind `drawing` puts them on paper.
class IllustrateTask final : public Task {
 public:
  std::string name() const override { return "illustrate"; }
  std::string summary() const override;
  std::vector<MethodInfo> methods() const override;
  std::vector<ValueInfo> values() const override;
  std::vector<std::string> problem_kinds() const override;
  void check(const Job& job) const override;
  JobResult run(const Job& job, const std::stop_token& stop) const override;
};

/// Checks a file of a kind that only this task takes. Throws InputError.
void check_illustration(const std::filesystem::path& path);

}  // namespace gcslab
