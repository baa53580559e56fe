#include "verifier/polynomial_terms.h"

#include <algorithm>
#include <numeric>

namespace gcslab::verifier {
namespace {

constexpr std::size_t kMaximumTerms = 2000;
constexpr std::size_t kMaximumProducts = 200'000;
constexpr int kMaximumDegree = 200;
constexpr std::size_t kMaximumBits = 20'000;

/// Thrown inside this file: the expression is not multiplied out.
struct NotExpanded {};

std::size_t bits_of(const PolynomialTerms& terms) {
  std::size_t bits = 0;
  for (const auto& [exponents, c] : terms)
    bits = std::max(bits, mpz_sizeinbase(c.get_num_mpz_t(), 2) + mpz_sizeinbase(c.get_den_mpz_t(), 2));
  return bits;
}

void add(PolynomialTerms& terms, const std::vector<int>& exponents, const Rational& coefficient) {
  const auto place = terms.try_emplace(exponents).first;
  place->second += coefficient;
  if (place->second == 0) terms.erase(place);
}

class Expander {
 public:
  /// `constants` are numbers of nodes, which get the variables after the others.
  explicit Expander(std::size_t variables, const std::vector<std::uint32_t>& constants = {})
      : variables_(variables + constants.size()) {
    for (const std::uint32_t node : constants) {
      std::vector<int> exponents(variables_, 0);
      exponents[variables++] = 1;
      done_.emplace(node, PolynomialTerms{{exponents, 1}});
    }
  }

  PolynomialTerms run(Expression root) {
    const std::vector<bool> reached = reachable_from({&root, 1});
    for (std::uint32_t i = 0; i < reached.size(); ++i) {
      if (!reached[i] || done_.contains(i)) continue;
      PolynomialTerms terms = terms_of(root.graph().node(i));
      check_size(terms);
      done_.emplace(i, std::move(terms));
    }
    return std::move(done_.at(root.index()));
  }

 private:
  PolynomialTerms terms_of(Expression e) {
    switch (e.operation()) {
      case Operation::constant:
        return scaled(unit(), e.constant());
      case Operation::variable: {
        std::vector<int> exponents(variables_, 0);
        exponents.at(static_cast<std::size_t>(e.variable())) = 1;
        return {{exponents, 1}};
      }
      case Operation::add:
        return sum(operand(e, 0), operand(e, 1));
      case Operation::subtract:
        return sum(operand(e, 0), scaled(operand(e, 1), -1));
      case Operation::negate:
        return scaled(operand(e, 0), -1);
      case Operation::multiply:
        return product(operand(e, 0), operand(e, 1));
      case Operation::sqr:
        return product(operand(e, 0), operand(e, 0));
      case Operation::divide:
        return quotient(operand(e, 0), operand(e, 1));
      case Operation::power_integer:
        return power(operand(e, 0), e.exponent());
      default:
        throw NotExpanded();
    }
  }

  const PolynomialTerms& operand(Expression e, int number) const {
    return done_.at(e.operand(number).index());
  }

  PolynomialTerms unit() const { return {{std::vector<int>(variables_, 0), 1}}; }

  static PolynomialTerms scaled(PolynomialTerms terms, const Rational& factor) {
    if (factor == 0) return {};
    for (auto& [exponents, c] : terms) c *= factor;
    return terms;
  }

  static PolynomialTerms sum(PolynomialTerms a, const PolynomialTerms& b) {
    for (const auto& [exponents, c] : b) add(a, exponents, c);
    return a;
  }

  PolynomialTerms product(const PolynomialTerms& a, const PolynomialTerms& b) {
    products_ += a.size() * b.size();
    if (products_ > kMaximumProducts || total_degree(a) + total_degree(b) > kMaximumDegree)
      throw NotExpanded();
    PolynomialTerms result;
    std::vector<int> exponents(variables_);
    for (const auto& [left, c] : a) {
      for (const auto& [right, d] : b) {
        std::ranges::transform(left, right, exponents.begin(), std::plus<>());
        add(result, exponents, c * d);
      }
    }
    return result;
  }

  PolynomialTerms quotient(const PolynomialTerms& a, const PolynomialTerms& b) const {
    if (b.size() != 1 || total_degree(b) != 0) throw NotExpanded();
    return scaled(a, 1 / b.begin()->second);
  }

  PolynomialTerms power(const PolynomialTerms& base, const Rational& exponent) {
    if (exponent < 0 || exponent * std::max(total_degree(base), 1) > kMaximumDegree) throw NotExpanded();
    PolynomialTerms result = unit();
    for (long i = exponent.get_num().get_si(); i > 0; --i) {
      result = product(result, base);
      check_size(result);
    }
    return result;
  }

  static void check_size(const PolynomialTerms& terms) {
    if (terms.size() > kMaximumTerms || bits_of(terms) > kMaximumBits) throw NotExpanded();
  }

  std::size_t variables_;
  std::size_t products_ = 0;
  std::map<std::uint32_t, PolynomialTerms> done_;
};

/// What is irrational and has no variables.
std::vector<std::uint32_t> constants_in(Expression root) {
  std::vector<std::uint32_t> result;
  const std::vector<bool> reached = reachable_from({&root, 1});
  std::vector<bool> is_fixed(reached.size(), false);
  for (std::uint32_t i = 0; i < reached.size(); ++i) {
    if (!reached[i]) continue;
    const Expression e = root.graph().node(i);
    is_fixed[i] = e.operation() != Operation::variable;
    for (int k = 0; k < info(e.operation()).operands; ++k)
      is_fixed[i] = is_fixed[i] && is_fixed[e.operand(k).index()];
    switch (e.operation()) {
      case Operation::constant:
      case Operation::add:
      case Operation::subtract:
      case Operation::negate:
      case Operation::multiply:
      case Operation::sqr:
      case Operation::divide:
      case Operation::power_integer:
        break;
      default:
        if (is_fixed[i]) result.push_back(i);
    }
  }
  return result;
}

}  // namespace

std::optional<TermsWithConstants> terms_with_constants(Expression expression, std::size_t variables) {
  const std::vector<std::uint32_t> nodes = constants_in(expression);
  try {
    TermsWithConstants result{Expander(variables, nodes).run(expression), {}};
    for (const std::uint32_t node : nodes) result.constants.push_back(expression.graph().node(node));
    return result;
  } catch (const NotExpanded&) {
    return std::nullopt;
  }
}

std::optional<PolynomialTerms> polynomial_terms(Expression expression, std::size_t variables) {
  try {
    return Expander(variables).run(expression);
  } catch (const NotExpanded&) {
    return std::nullopt;
  }
}

int total_degree(const PolynomialTerms& terms) {
  int degree = 0;
  for (const auto& [exponents, coefficient] : terms)
    degree = std::max(degree, std::accumulate(exponents.begin(), exponents.end(), 0));
  return degree;
}

}  // namespace gcslab::verifier
