#pragma once

#include <optional>
#include <vector>

#include "box_solver/search.h"
#include "interval/fast_interval.h"

namespace gcslab {

/// Inequalities at proven roots.
class InequalityCheck {
 public:
  explicit InequalityCheck(const SystemFunctions& functions);

  /// What holds everywhere in the box of a root; nothing when some inequality is violated everywhere in it,
  /// so that the root is no solution.
  std::optional<InequalityState> at(const Box& box);

 private:
  std::vector<TapeEvaluator<FastInterval>> evaluators_;
};

}  // namespace gcslab
