#pragma once

// A task for tests of the runner: its methods sleep, spin, allocate, crash, fail and succeed on request.

#include "experiments/tasks/catalogue.h"

namespace gcslab {

class SelftestTask : public Task {
 public:
  std::string name() const override { return "selftest"; }
  std::string summary() const override { return "misbehaves on request"; }
  std::vector<MethodInfo> methods() const override;
  std::vector<OptionSpec> parameters() const override;
  std::vector<ValueInfo> values() const override { return {{"answer", "what the method computes"}}; }
  std::vector<std::string> problem_kinds() const override { return {"number"}; }
  /// The problem "wrong-kind" is none of the task's.
  void check(const Job& job) const override;
  JobResult run(const Job& job, const std::stop_token& stop) const override;
};

/// The task, and the problems one .. nine, wrong-kind, suite:all (one, two, three) and suite:odd (one,
/// three). Their content is their name and the environment variable SELFTEST_EDITION.
const Catalogue& selftest_catalogue();

}  // namespace gcslab
