#include "expression/expression.h"

#include <algorithm>

#include "base/check.h"
#include "base/error.h"

namespace gcslab {
namespace {

/// Constants that are computed and have more bits are refused: nobody writes them on purpose.
constexpr std::size_t kMaximumConstantBits = 1 << 16;
/// So are exponents that no int holds with room to spare.
constexpr int kMaximumExponent = 1'000'000;

std::size_t bits_of(const Rational& value) {
  return mpz_sizeinbase(value.get_num_mpz_t(), 2) + mpz_sizeinbase(value.get_den_mpz_t(), 2);
}

Rational integer_power(const Rational& base, const mpz_class& exponent) {
  if (base == 0 && exponent < 0) throw InputError("0 has no negative power");
  const mpz_class size = abs(exponent);
  if (!size.fits_ulong_p() || (base != 0 && abs(base) != 1 && size * bits_of(base) > kMaximumConstantBits)) {
    throw InputError("a constant power has more than " + std::to_string(kMaximumConstantBits) + " bits");
  }
  Rational result;
  mpz_pow_ui(result.get_num_mpz_t(), base.get_num_mpz_t(), size.get_ui());
  mpz_pow_ui(result.get_den_mpz_t(), base.get_den_mpz_t(), size.get_ui());
  if (exponent < 0) result = 1 / result;
  return result;
}

Rational folded(Operation operation, const Rational& a, const Rational& b) {
  switch (operation) {
    case Operation::add:
      return a + b;
    case Operation::subtract:
      return a - b;
    case Operation::multiply:
      return a * b;
    case Operation::divide:
      if (b == 0) throw InputError("division by the constant 0");
      return a / b;
    case Operation::min:
      return a < b ? a : b;
    case Operation::max:
      return a < b ? b : a;
    default:
      GCSLAB_CHECK(false);
  }
}

}  // namespace

Operation Expression::operation() const { return graph_->nodes_[index_].operation; }

Expression Expression::operand(int number) const {
  GCSLAB_CHECK(number >= 0 && number < info(operation()).operands);
  const ExpressionGraph::Node& node = graph_->nodes_[index_];
  return {graph_, number == 0 ? node.a : node.b};
}

const Rational& Expression::constant() const {
  GCSLAB_CHECK(operation() == Operation::constant);
  return graph_->constants_[graph_->nodes_[index_].a];
}

int Expression::variable() const {
  GCSLAB_CHECK(operation() == Operation::variable);
  return static_cast<int>(graph_->nodes_[index_].a);
}

const Rational& Expression::exponent() const {
  GCSLAB_CHECK(operation() == Operation::power_integer || operation() == Operation::power_rational);
  return graph_->constants_[graph_->nodes_[index_].b];
}

bool Expression::is_total() const { return graph_->total_[index_]; }

std::size_t ExpressionGraph::NodeHash::operator()(const Node& node) const {
  std::size_t hash = static_cast<std::size_t>(node.operation);
  hash = hash * 0x9e3779b97f4a7c15ULL + node.a;
  return (hash ^ (hash >> 29)) * 0xbf58476d1ce4e5b9ULL + node.b;
}

Expression ExpressionGraph::intern(const Node& node) {
  const auto [place, is_new] = index_of_node_.try_emplace(node, static_cast<std::uint32_t>(nodes_.size()));
  if (is_new) {
    const OperationInfo& operation = info(node.operation);
    bool total = operation.total;
    if (node.operation == Operation::power_integer) total = constants_[node.b] >= 0;
    if (node.operation == Operation::divide) {
      const Node& divisor = nodes_[node.b];
      total = divisor.operation == Operation::constant && constants_[divisor.a] != 0;
    }
    if (operation.operands >= 1) total = total && total_[node.a];
    if (operation.operands == 2) total = total && total_[node.b];
    nodes_.push_back(node);
    total_.push_back(total);
  }
  return {this, place->second};
}

std::uint32_t ExpressionGraph::intern_constant(const Rational& value) {
  const auto [place, is_new] =
      index_of_constant_.try_emplace(value.get_str(), static_cast<std::uint32_t>(constants_.size()));
  if (is_new) constants_.push_back(value);
  return place->second;
}

Expression ExpressionGraph::constant(const Rational& value) {
  return intern({Operation::constant, intern_constant(value), 0});
}

Expression ExpressionGraph::pi() { return intern({Operation::pi, 0, 0}); }

Expression ExpressionGraph::variable(int number) {
  GCSLAB_CHECK(number >= 0);
  return intern({Operation::variable, static_cast<std::uint32_t>(number), 0});
}

Expression ExpressionGraph::apply(Operation operation, Expression a) {
  GCSLAB_CHECK(&a.graph() == this && info(operation).operands == 1);
  if (a.is_constant()) {
    if (operation == Operation::negate) return constant(-a.constant());
    if (operation == Operation::abs) return constant(abs(a.constant()));
    if (operation == Operation::sqr) return power(a, 2);
  }
  if (operation == Operation::negate && a.operation() == Operation::negate) return a.operand(0);
  return intern({operation, a.index(), 0});
}

Expression ExpressionGraph::fold(Operation operation, const Rational& a, const Rational& b) {
  const Rational value = folded(operation, a, b);
  if (bits_of(value) > std::max({kMaximumConstantBits, bits_of(a), bits_of(b)})) {
    throw InputError("a constant has more than " + std::to_string(kMaximumConstantBits) + " bits");
  }
  return constant(value);
}

Expression ExpressionGraph::apply(Operation operation, Expression a, Expression b) {
  GCSLAB_CHECK(&a.graph() == this && &b.graph() == this && info(operation).operands == 2);
  if (a.is_constant() && b.is_constant()) return fold(operation, a.constant(), b.constant());
  switch (operation) {
    case Operation::add:
      if (a.is_constant(0)) return b;
      if (b.is_constant(0)) return a;
      break;
    case Operation::subtract:
      if (b.is_constant(0)) return a;
      if (a.is_constant(0)) return apply(Operation::negate, b);
      break;
    case Operation::multiply:
      if (a.is_constant(1)) return b;
      if (b.is_constant(1)) return a;
      if (a.is_constant(0) && b.is_total()) return a;
      if (b.is_constant(0) && a.is_total()) return b;
      break;
    case Operation::divide:
      if (b.is_constant(0)) throw InputError("division by the constant 0");
      if (b.is_constant(1)) return a;
      break;
    default:
      break;
  }
  const bool commutes = operation == Operation::add || operation == Operation::multiply ||
                        operation == Operation::min || operation == Operation::max;
  if (commutes) {  // one node for both orders, printed as first written
    const auto swapped = index_of_node_.find({operation, b.index(), a.index()});
    if (swapped != index_of_node_.end()) return {this, swapped->second};
  }
  return intern({operation, a.index(), b.index()});
}

Expression ExpressionGraph::power(Expression base, const Rational& exponent) {
  GCSLAB_CHECK(&base.graph() == this);
  const bool whole = exponent.get_den() == 1;
  if (whole && base.is_constant()) return constant(integer_power(base.constant(), exponent.get_num()));
  if (abs(exponent.get_num()) > kMaximumExponent || exponent.get_den() > kMaximumExponent) {
    throw InputError("the exponent " + exponent.get_str() + " is too large");
  }
  if (exponent == 1) return base;
  if (exponent == 2) return apply(Operation::sqr, base);
  if (exponent == 0 && base.is_total()) return constant(1);
  if (exponent == Rational(1, 2)) return apply(Operation::sqrt, base);
  if (exponent == Rational(1, 3)) return apply(Operation::cbrt, base);
  const Operation operation = whole ? Operation::power_integer : Operation::power_rational;
  return intern({operation, base.index(), intern_constant(exponent)});
}

std::vector<bool> reachable_from(std::span<const Expression> roots) {
  std::uint32_t size = 0;
  for (const Expression& root : roots) size = std::max(size, root.index() + 1);
  std::vector<bool> reached(size, false);
  for (const Expression& root : roots) reached[root.index()] = true;
  for (std::uint32_t i = size; i-- > 0;) {
    if (!reached[i]) continue;
    const Expression e = roots.front().graph().node(i);
    for (int k = 0; k < info(e.operation()).operands; ++k) reached[e.operand(k).index()] = true;
  }
  return reached;
}

Expression operator+(Expression a, Expression b) { return a.graph().apply(Operation::add, a, b); }
Expression operator-(Expression a, Expression b) { return a.graph().apply(Operation::subtract, a, b); }
Expression operator*(Expression a, Expression b) { return a.graph().apply(Operation::multiply, a, b); }
Expression operator/(Expression a, Expression b) { return a.graph().apply(Operation::divide, a, b); }
Expression operator-(Expression a) { return a.graph().apply(Operation::negate, a); }
Expression sqr(Expression a) { return a.graph().apply(Operation::sqr, a); }
Expression pow(Expression a, int exponent) { return a.graph().power(a, exponent); }

}  // namespace gcslab
