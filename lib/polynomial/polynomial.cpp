#include "polynomial/polynomial.h"

#include <algorithm>
#include <numeric>

#include "base/check.h"

namespace gcslab {
namespace {

Rational integer_power(const Rational& base, int exponent) {
  Rational result;
  mpz_pow_ui(result.get_num_mpz_t(), base.get_num_mpz_t(), static_cast<unsigned long>(exponent));
  mpz_pow_ui(result.get_den_mpz_t(), base.get_den_mpz_t(), static_cast<unsigned long>(exponent));
  return result;
}

std::size_t as_index(int number) { return static_cast<std::size_t>(number); }

/// (c x^a)^n, n > 0.
Polynomial monomial_power(const Polynomial& base, int exponent) {
  Exponents exponents = base.terms().begin()->first;
  const Rational& coefficient = base.terms().begin()->second;
  for (int& e : exponents) e *= exponent;
  Polynomial result(base.variables());
  result.add_term(exponents, integer_power(coefficient, exponent));
  return result;
}

}  // namespace

Polynomial::Polynomial(int variables) : variables_(variables) { GCSLAB_CHECK(variables >= 0); }

Polynomial Polynomial::constant(int variables, const Rational& value) {
  Polynomial result(variables);
  result.add_term(Exponents(as_index(variables), 0), value);
  return result;
}

Polynomial Polynomial::variable(int variables, int number) {
  GCSLAB_CHECK(number >= 0 && number < variables);
  Exponents exponents(as_index(variables), 0);
  exponents[as_index(number)] = 1;
  Polynomial result(variables);
  result.add_term(exponents, 1);
  return result;
}

Rational Polynomial::coefficient(const Exponents& exponents) const {
  const auto place = terms_.find(exponents);
  return place == terms_.end() ? Rational(0) : place->second;
}

Exponents Polynomial::degrees() const {
  Exponents result(as_index(variables_), 0);
  for (const auto& [exponents, coefficient] : terms_) {
    std::ranges::transform(result, exponents, result.begin(), [](int a, int b) { return std::max(a, b); });
  }
  return result;
}

int Polynomial::total_degree() const {
  int result = 0;
  for (const auto& [exponents, coefficient] : terms_) {
    result = std::max(result, std::accumulate(exponents.begin(), exponents.end(), 0));
  }
  return result;
}

void Polynomial::add_term(const Exponents& exponents, const Rational& coefficient) {
  GCSLAB_CHECK(exponents.size() == as_index(variables_));
  if (coefficient == 0) return;
  const auto [place, is_new] = terms_.try_emplace(exponents, coefficient);
  if (is_new) return;
  place->second += coefficient;
  if (place->second == 0) terms_.erase(place);
}

Polynomial& Polynomial::operator+=(const Polynomial& other) {
  if (&other == this) return *this *= Rational(2);
  for (const auto& [exponents, coefficient] : other.terms_) add_term(exponents, coefficient);
  return *this;
}

Polynomial& Polynomial::operator-=(const Polynomial& other) {
  if (&other == this) return *this *= Rational(0);
  for (const auto& [exponents, coefficient] : other.terms_) add_term(exponents, -coefficient);
  return *this;
}

Polynomial& Polynomial::operator*=(const Rational& factor) {
  if (factor == 0) terms_.clear();
  for (auto& [exponents, coefficient] : terms_) coefficient *= factor;
  return *this;
}

Polynomial Polynomial::derivative(int variable) const {
  GCSLAB_CHECK(variable >= 0 && variable < variables_);
  Polynomial result(variables_);
  for (const auto& [exponents, coefficient] : terms_) {
    const int exponent = exponents[as_index(variable)];
    if (exponent == 0) continue;
    Exponents lowered = exponents;
    --lowered[as_index(variable)];
    result.add_term(lowered, coefficient * exponent);
  }
  return result;
}

Rational Polynomial::evaluate(std::span<const Rational> point) const {
  GCSLAB_CHECK(point.size() == as_index(variables_));
  Rational result = 0;
  for (const auto& [exponents, coefficient] : terms_) {
    Rational term = coefficient;
    for (std::size_t i = 0; i < point.size(); ++i) {
      if (exponents[i] > 0) term *= integer_power(point[i], exponents[i]);
    }
    result += term;
  }
  return result;
}

Polynomial Polynomial::restrict(int variable, const Rational& value) const {
  GCSLAB_CHECK(variable >= 0 && variable < variables_);
  Polynomial result(variables_);
  for (const auto& [exponents, coefficient] : terms_) {
    Exponents without = exponents;
    without[as_index(variable)] = 0;
    result.add_term(without, coefficient * integer_power(value, exponents[as_index(variable)]));
  }
  return result;
}

Expression Polynomial::to_expression(ExpressionGraph& graph) const {
  Expression result = graph.constant(0);
  for (auto term = terms_.rbegin(); term != terms_.rend(); ++term) {
    result = result + graph.constant(term->second) * monomial_expression(graph, term->first);
  }
  return result;
}

Polynomial operator+(Polynomial a, const Polynomial& b) { return a += b; }
Polynomial operator-(Polynomial a, const Polynomial& b) { return a -= b; }
Polynomial operator-(Polynomial a) { return a *= Rational(-1); }
Polynomial operator*(Polynomial a, const Rational& factor) { return a *= factor; }
Polynomial operator*(const Rational& factor, Polynomial a) { return a *= factor; }

Polynomial operator*(const Polynomial& a, const Polynomial& b) {
  GCSLAB_CHECK(a.variables() == b.variables());
  Polynomial result(a.variables());
  Exponents exponents(as_index(a.variables()));
  Rational product;
  for (const auto& [left, left_coefficient] : a.terms()) {
    for (const auto& [right, right_coefficient] : b.terms()) {
      std::ranges::transform(left, right, exponents.begin(), [](int p, int q) { return p + q; });
      product = left_coefficient * right_coefficient;
      result.add_term(exponents, product);
    }
  }
  return result;
}

Polynomial pow(const Polynomial& base, int exponent) {
  GCSLAB_CHECK(exponent >= 0);
  if (base.terms().size() == 1 && exponent > 0) return monomial_power(base, exponent);
  Polynomial result = Polynomial::constant(base.variables(), 1);
  for (int i = 0; i < exponent && !result.is_zero(); ++i) result = result * base;
  return result;
}

Expression monomial_expression(ExpressionGraph& graph, const Exponents& exponents) {
  Expression result = graph.constant(1);
  for (std::size_t i = 0; i < exponents.size(); ++i) {
    if (exponents[i] == 0) continue;
    const Expression x = graph.variable(static_cast<int>(i));
    result = result * (exponents[i] == 2 ? sqr(x) : pow(x, exponents[i]));
  }
  return result;
}

}  // namespace gcslab
