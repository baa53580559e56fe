#include "box_solver/graph_strips.h"

#include <algorithm>
#include <cmath>

namespace gcslab {
namespace {

/// phi of the only variable of the graph.
Expression step_in(ExpressionGraph& graph, Expression step) {
  const Expression x = graph.variable(0);
  const Operation operation = step.operation();
  const bool is_power = operation == Operation::power_integer || operation == Operation::power_rational;
  return is_power ? graph.power(x, step.exponent()) : graph.apply(operation, x);
}

}  // namespace

GraphStrips::GraphStrips(Expression step)
    : graph_(std::make_unique<ExpressionGraph>()),
      tape_(std::make_unique<Tape>(step_in(*graph_, step), 1)),
      evaluator_(*tape_) {}

GraphStrips::Values GraphStrips::over(const Interval& x) {
  Values result;
  result.x = FastInterval(x);
  evaluator_.evaluate({&result.x, 1});
  result.values = evaluator_.value();
  if (evaluator_.defined_everywhere()) result.slopes = evaluator_.reverse_gradient()[0];
  return result;
}

/// By the values, and by slopes from either end: these are exact where t - slope x is monotone.
FastInterval GraphStrips::range_on(std::size_t piece, double slope) const {
  const FastInterval s(slope);
  const Values& inside = pieces_[piece];
  FastInterval range = inside.values - s * inside.x;
  if (!is_bounded(inside.slopes.interval())) return range;
  for (const Values& end : {ends_[piece], ends_[piece + 1]}) {
    range = intersection(range, end.values - s * end.x + (inside.slopes - s) * (inside.x - end.x));
  }
  return range;
}

Strip GraphStrips::strip(double slope) const {
  if (!std::isfinite(slope)) return {};
  FastInterval range;
  for (std::size_t i = 0; i < kPieces; ++i) range = hull(range, range_on(i, slope));
  return {slope, range.interval()};
}

const StripsOfGraph& GraphStrips::around(const Interval& x) {
  const double piece = width(x) / kPieces;
  double start = x.lower;
  ends_[0] = over(Interval(start));
  for (std::size_t i = 0; i < kPieces; ++i) {
    const double end = i + 1 == kPieces ? x.upper : std::min(start + piece, x.upper);
    pieces_[i] = over(Interval(start, end));
    ends_[i + 1] = over(Interval(end));
    start = end;
  }
  const auto middle = [](const FastInterval& value) { return midpoint(value.interval()); };
  const double rise = middle(ends_.back().values) - middle(ends_.front().values);
  strips_ = {strip(middle(ends_.front().slopes)), strip(middle(ends_.back().slopes)), strip(rise / width(x))};
  return strips_;
}

}  // namespace gcslab
