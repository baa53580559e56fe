#include "expression/substitute.h"

#include <optional>
#include <vector>

#include "base/check.h"

namespace gcslab {
namespace {

Expression rebuilt(Expression node, ExpressionGraph& target, std::span<const Expression> replacements,
                   const std::vector<std::optional<Expression>>& done) {
  const auto operand = [&](int number) { return *done[node.operand(number).index()]; };
  switch (node.operation()) {
    case Operation::constant:
      return target.constant(node.constant());
    case Operation::pi:
      return target.pi();
    case Operation::variable:
      GCSLAB_CHECK(static_cast<std::size_t>(node.variable()) < replacements.size());
      return replacements[static_cast<std::size_t>(node.variable())];
    case Operation::power_integer:
    case Operation::power_rational:
      return target.power(operand(0), node.exponent());
    default:
      break;
  }
  if (info(node.operation()).operands == 1) return target.apply(node.operation(), operand(0));
  return target.apply(node.operation(), operand(0), operand(1));
}

}  // namespace

Expression substitute(Expression expression, ExpressionGraph& target,
                      std::span<const Expression> replacements) {
  const std::vector<bool> reached = reachable_from({&expression, 1});
  std::vector<std::optional<Expression>> done(reached.size());
  for (std::uint32_t i = 0; i < reached.size(); ++i) {
    if (reached[i]) done[i] = rebuilt(expression.graph().node(i), target, replacements, done);
  }
  return *done[expression.index()];
}

}  // namespace gcslab
