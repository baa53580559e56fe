#include "polynomial/recognise.h"

#include <algorithm>
#include <unordered_map>

#include "base/check.h"

namespace gcslab {
namespace {

/// Thrown inside this file only: the reason why an expression is no polynomial.
struct Refusal {
  std::string reason;
};

/// The nodes below `root`, operands before what uses them.
/// The bits of the longest coefficient.
std::size_t coefficient_bits(const Polynomial& polynomial) {
  std::size_t bits = 0;
  for (const auto& [exponents, value] : polynomial.terms()) {
    bits =
        std::max(bits, mpz_sizeinbase(value.get_num_mpz_t(), 2) + mpz_sizeinbase(value.get_den_mpz_t(), 2));
  }
  return bits;
}

class Recogniser {
 public:
  Recogniser(int variables, const RecognitionLimits& limits) : variables_(variables), limits_(limits) {}

  Polynomial run(Expression root) {
    const std::vector<bool> reached = reachable_from({&root, 1});
    for (std::uint32_t index = 0; index < reached.size(); ++index) {
      if (!reached[index]) continue;
      Polynomial value = polynomial_of(root.graph().node(index));
      check_size(value);
      done_.emplace(index, std::move(value));
    }
    return std::move(done_.at(root.index()));
  }

 private:
  const Polynomial& operand(Expression node, int number) const {
    return done_.at(node.operand(number).index());
  }

  Polynomial polynomial_of(Expression node) {
    switch (node.operation()) {
      case Operation::constant:
        return Polynomial::constant(variables_, node.constant());
      case Operation::variable:
        return Polynomial::variable(variables_, node.variable());
      case Operation::add:
        return operand(node, 0) + operand(node, 1);
      case Operation::subtract:
        return operand(node, 0) - operand(node, 1);
      case Operation::negate:
        return -operand(node, 0);
      case Operation::multiply:
        return product(operand(node, 0), operand(node, 1));
      case Operation::divide:
        return quotient(operand(node, 0), node.operand(1));
      case Operation::sqr:
        return product(operand(node, 0), operand(node, 0));
      case Operation::power_integer:
        return power(operand(node, 0), node.exponent());
      case Operation::power_rational:
        throw Refusal{"contains a power with a fractional exponent"};
      case Operation::pi:
        throw Refusal{"contains pi"};
      default:
        throw Refusal{"contains " + std::string(info(node.operation()).name)};
    }
  }

  Polynomial product(const Polynomial& a, const Polynomial& b) {
    if (a.total_degree() + b.total_degree() > limits_.degree) refuse_degree();
    products_ += a.terms().size() * b.terms().size();
    if (products_ > limits_.products) refuse_size();
    return a * b;
  }

  Polynomial quotient(const Polynomial& a, Expression divisor) {
    const Polynomial& b = done_.at(divisor.index());
    if (b.total_degree() > 0) throw Refusal{"divides by a variable"};
    if (b.is_zero()) throw Refusal{"divides by zero"};
    return a * Rational(1 / b.terms().begin()->second);
  }

  Polynomial power(const Polynomial& base, const Rational& exponent) {
    if (exponent < 0) throw Refusal{"contains a negative power"};
    const int degree = base.total_degree();
    if (exponent * std::max(degree, 1) > limits_.degree) refuse_degree();
    const int count = static_cast<int>(exponent.get_num().get_si());
    if (base.terms().size() == 1) {
      if (coefficient_bits(base) * static_cast<std::size_t>(count) > limits_.bits) refuse_size();
      return pow(base, count);
    }
    Polynomial result = Polynomial::constant(variables_, 1);
    for (int i = 0; i < count && !result.is_zero(); ++i) {
      result = product(result, base);
      check_size(result);
    }
    return result;
  }

  void check_size(const Polynomial& value) const {
    if (value.terms().size() > limits_.terms || coefficient_bits(value) > limits_.bits) refuse_size();
  }

  [[noreturn]] void refuse_size() const {
    throw Refusal{"expands beyond " + std::to_string(limits_.terms) + " terms, " +
                  std::to_string(limits_.products) + " products or " + std::to_string(limits_.bits) +
                  " bits of a coefficient"};
  }
  [[noreturn]] void refuse_degree() const {
    throw Refusal{"has a degree above " + std::to_string(limits_.degree)};
  }

  int variables_;
  RecognitionLimits limits_;
  std::size_t products_ = 0;
  std::unordered_map<std::uint32_t, Polynomial> done_;
};

}  // namespace

Recognition recognise_polynomial(Expression expression, int variables, const RecognitionLimits& limits) {
  try {
    return {Recogniser(variables, limits).run(expression), ""};
  } catch (const Refusal& refusal) {
    return {std::nullopt, refusal.reason};
  }
}

}  // namespace gcslab
