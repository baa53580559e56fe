#include "box_solver/term_ranges.h"

namespace gcslab {

TermRanges::TermRanges(const LiftedSystem& system) {
  const std::vector<Term>& terms = system.terms();
  if (terms.empty()) return;
  const NumberTraits<FastInterval>::Scope scope;
  std::vector<Expression> expressions;
  for (std::size_t t = 0; t < terms.size(); ++t) {
    expressions.push_back(terms[t].expression);
    if (!terms[t].argument) continue;
    graphs_.push_back({system.variables() + t, *terms[t].argument});
    strips_.emplace_back(terms[t].expression);
  }
  tape_.emplace(expressions, static_cast<int>(system.variables()));
  evaluator_.emplace(*tape_);
}

Box TermRanges::lift(const Box& box) {
  Box lifted = box;
  if (!tape_) return lifted;
  const NumberTraits<FastInterval>::Scope scope;
  const std::vector<FastInterval> sides(box.begin(), box.end());
  evaluator_->evaluate(sides);
  for (std::size_t t = 0; t < tape_->outputs().size(); ++t) lifted.push_back(evaluator_->value(t).interval());
  return lifted;
}

const StripsOfGraph& TermRanges::strips(std::size_t graph, const Box& lifted) {
  const NumberTraits<FastInterval>::Scope scope;
  return strips_[graph].around(lifted[graphs_[graph].argument]);
}

}  // namespace gcslab
