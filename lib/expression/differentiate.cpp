#include "expression/differentiate.h"

#include <optional>

#include "base/check.h"
#include "base/error.h"

namespace gcslab {
namespace {

/// The derivative of a function of one argument with respect to that argument.
Expression outer_derivative(Expression e) {
  ExpressionGraph& graph = e.graph();
  const Expression x = e.operand(0);
  const Expression one = graph.constant(1);
  switch (e.operation()) {
    case Operation::sqr:
      return graph.constant(2) * x;
    case Operation::sqrt:
      return one / (graph.constant(2) * e);
    case Operation::cbrt:
      return one / (graph.constant(3) * sqr(e));
    case Operation::exp:
      return e;
    case Operation::log:
      return one / x;
    case Operation::sin:
      return graph.apply(Operation::cos, x);
    case Operation::cos:
      return -graph.apply(Operation::sin, x);
    case Operation::tan:
      return one + sqr(e);
    case Operation::asin:
      return one / graph.apply(Operation::sqrt, one - sqr(x));
    case Operation::acos:
      return -(one / graph.apply(Operation::sqrt, one - sqr(x)));
    case Operation::atan:
      return one / (one + sqr(x));
    case Operation::power_integer:
    case Operation::power_rational:
      return graph.constant(e.exponent()) * graph.power(x, e.exponent() - 1);
    default:
      throw NotApplicable(std::string(info(e.operation()).name) + " has no derivative where it kinks");
  }
}

/// Derivatives of the nodes met so far; empty where it is zero.
using Derivatives = std::vector<std::optional<Expression>>;

std::optional<Expression> derivative_of_sum(Expression e, const Derivatives& known) {
  const auto& a = known[e.operand(0).index()];
  const auto& b = known[e.operand(1).index()];
  if (!b) return a;
  if (e.operation() == Operation::add) return a ? *a + *b : *b;
  return a ? *a - *b : -*b;
}

std::optional<Expression> derivative_of_product(Expression e, const Derivatives& known) {
  const auto& a = known[e.operand(0).index()];
  const auto& b = known[e.operand(1).index()];
  if (a && b) return *a * e.operand(1) + e.operand(0) * *b;
  if (a) return *a * e.operand(1);
  if (b) return e.operand(0) * *b;
  return std::nullopt;
}

std::optional<Expression> derivative_of_quotient(Expression e, const Derivatives& known) {
  const auto& a = known[e.operand(0).index()];
  const auto& b = known[e.operand(1).index()];
  if (!b) return a ? std::optional<Expression>(*a / e.operand(1)) : std::nullopt;
  const Expression correction = e * *b;  // (a/b)' = (a' - (a/b) b') / b
  return (a ? *a - correction : -correction) / e.operand(1);
}

std::optional<Expression> derivative_of_node(Expression e, int variable, const Derivatives& known) {
  switch (e.operation()) {
    case Operation::constant:
    case Operation::pi:
      return std::nullopt;
    case Operation::variable:
      return e.variable() == variable ? std::optional<Expression>(e.graph().constant(1)) : std::nullopt;
    case Operation::add:
    case Operation::subtract:
      return derivative_of_sum(e, known);
    case Operation::multiply:
      return derivative_of_product(e, known);
    case Operation::divide:
      return derivative_of_quotient(e, known);
    case Operation::min:
    case Operation::max:
      if (!known[e.operand(0).index()] && !known[e.operand(1).index()]) return std::nullopt;
      throw NotApplicable("min and max have no derivative where they kink");
    default:
      break;
  }
  const auto& inner = known[e.operand(0).index()];
  if (!inner) return std::nullopt;
  if (e.operation() == Operation::negate) return -*inner;
  return outer_derivative(e) * *inner;
}

}  // namespace

Expression differentiate(Expression expression, int variable) {
  const std::vector<bool> needed = reachable_from({&expression, 1});
  Derivatives known(needed.size());
  for (std::uint32_t i = 0; i < needed.size(); ++i) {
    if (needed[i]) known[i] = derivative_of_node(expression.graph().node(i), variable, known);
  }
  return known.back().value_or(expression.graph().constant(0));
}

std::vector<Expression> gradient(Expression expression, int variables) {
  std::vector<Expression> result;
  result.reserve(static_cast<std::size_t>(variables));
  for (int i = 0; i < variables; ++i) result.push_back(differentiate(expression, i));
  return result;
}

}  // namespace gcslab
