#include "box_solver/inequality_check.h"

#include "interval/fast_interval.h"

namespace gcslab {

InequalityCheck::InequalityCheck(const SystemFunctions& functions) {
  const NumberTraits<FastInterval>::Scope scope;
  for (const SystemFunction& f : functions.inequalities()) evaluators_.emplace_back(f.tape);
}

std::optional<InequalityState> InequalityCheck::at(const Box& box) {
  const NumberTraits<FastInterval>::Scope scope;
  std::vector<FastInterval> point;
  for (const Interval& side : box) point.emplace_back(side);
  InequalityState state = InequalityState::proved;
  for (auto& evaluator : evaluators_) {
    evaluator.evaluate(point);
    const Interval value = evaluator.value().interval();
    if (is_empty(value) || value.lower > 0) return std::nullopt;
    if (value.upper > 0 || !evaluator.defined_everywhere()) state = InequalityState::undecided;
  }
  return state;
}

}  // namespace gcslab
