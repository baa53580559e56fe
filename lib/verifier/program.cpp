#include "verifier/program.h"

#include "base/check.h"

namespace gcslab::verifier {
namespace {

bool has_exponent(Operation operation) {
  return operation == Operation::power_integer || operation == Operation::power_rational;
}

}  // namespace

Program::Program(Expression expression, std::size_t variables)
    : place_of_variable_(variables, kNowhere), gradient_(variables) {
  const std::vector<bool> reached = reachable_from({&expression, 1});
  std::vector<std::uint32_t> place_of(reached.size(), kNowhere);
  for (std::uint32_t i = 0; i < reached.size(); ++i) {
    if (!reached[i]) continue;
    const Expression e = expression.graph().node(i);
    Node node{e.operation(), 0, 0, {}};
    const int operands = info(e.operation()).operands;
    if (operands >= 1) node.a = place_of[e.operand(0).index()];
    if (operands == 2) node.b = place_of[e.operand(1).index()];
    if (has_exponent(e.operation())) node.exponent = e.exponent();
    place_of[i] = static_cast<std::uint32_t>(nodes_.size());
    nodes_.push_back(node);
    values_.emplace_back();
    if (e.is_constant()) values_.back() = Range(e.constant());
    if (e.operation() == Operation::pi) values_.back() = Range::pi();
    if (e.operation() == Operation::variable)
      place_of_variable_.at(static_cast<std::size_t>(e.variable())) = place_of[i];
  }
  for (std::size_t i = 0; i < variables; ++i) {
    if (place_of_variable_[i] != kNowhere) variables_.push_back(i);
  }
  adjoints_.resize(nodes_.size());
}

void Program::forward(std::span<const Range> box) {
  for (const std::size_t i : variables_) values_[place_of_variable_[i]] = box[i];
  for (std::size_t place = 0; place < nodes_.size(); ++place) {
    if (info(nodes_[place].operation).operands > 0) values_[place] = value_of(nodes_[place]);
  }
}

const Range& Program::evaluate(std::span<const Range> box) {
  forward(box);
  return values_.back();
}

Range Program::value_of(const Node& node) const {
  const Range& a = values_[node.a];
  const Range& b = values_[node.b];
  switch (node.operation) {
    case Operation::add:
      return a + b;
    case Operation::subtract:
      return a - b;
    case Operation::multiply:
      return a * b;
    case Operation::divide:
      return a / b;
    case Operation::negate:
      return -a;
    case Operation::sqr:
      return sqr(a);
    case Operation::power_integer:
    case Operation::power_rational:
      return power(a, node.exponent);
    case Operation::sqrt:
      return sqrt(a);
    case Operation::cbrt:
      return cbrt(a);
    case Operation::exp:
      return exp(a);
    case Operation::log:
      return log(a);
    case Operation::sin:
      return sin(a);
    case Operation::cos:
      return cos(a);
    case Operation::tan:
      return tan(a);
    case Operation::asin:
      return asin(a);
    case Operation::acos:
      return acos(a);
    case Operation::atan:
      return atan(a);
    case Operation::abs:
      return abs(a);
    case Operation::min:
      return min(a, b);
    case Operation::max:
      return max(a, b);
    case Operation::constant:
    case Operation::pi:
    case Operation::variable:
      break;
  }
  GCSLAB_CHECK(false);
}

bool Program::is_defined(const Node& node, const Range& value) const {
  const Range& a = values_[node.a];
  switch (node.operation) {
    case Operation::divide:
      return !values_[node.b].contains_zero();
    case Operation::sqrt:
      return mpfr_sgn(a.lower()) >= 0;
    case Operation::log:
      return mpfr_sgn(a.lower()) > 0;
    case Operation::asin:
    case Operation::acos:
      return a.is_within(Interval(-1, 1));
    case Operation::tan:
      return value.is_bounded();
    case Operation::power_integer:
      return node.exponent >= 0 || !a.contains_zero();
    case Operation::power_rational: {
      const bool even_root = mpz_even_p(node.exponent.get_den_mpz_t()) != 0;
      if (even_root && mpfr_sgn(a.lower()) < 0) return false;
      return node.exponent >= 0 || !a.contains_zero();
    }
    default:
      return true;
  }
}

bool Program::is_defined_everywhere() const {
  for (std::size_t place = 0; place < nodes_.size(); ++place) {
    if (values_[place].is_empty() || !is_defined(nodes_[place], values_[place])) return false;
  }
  return true;
}

bool Program::is_constant(std::uint32_t place) const {
  return nodes_[place].operation == Operation::constant || nodes_[place].operation == Operation::pi;
}

}  // namespace gcslab::verifier
