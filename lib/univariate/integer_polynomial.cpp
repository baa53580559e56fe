#include "univariate/integer_polynomial.h"

#include "base/check.h"

namespace gcslab {
namespace {

std::vector<FastInterval> enclosures(const IntegerPolynomial& polynomial) {
  const NumberTraits<FastInterval>::Scope scope;
  std::vector<FastInterval> result;
  for (const mpz_class& c : polynomial.coefficients())
    result.push_back(NumberTraits<FastInterval>::from_rational(Rational(c)));
  return result;
}

mpz_class content(const IntegerPolynomial& a) {
  mpz_class result;
  for (const mpz_class& c : a.coefficients()) {
    result = gcd(result, c);
    if (result == 1) break;
  }
  return result;
}

}  // namespace

IntegerPolynomial::IntegerPolynomial(std::vector<mpz_class> coefficients)
    : coefficients_(std::move(coefficients)) {
  while (!coefficients_.empty() && coefficients_.back() == 0) coefficients_.pop_back();
}

IntegerPolynomial IntegerPolynomial::derivative() const {
  std::vector<mpz_class> result;
  for (std::size_t k = 1; k < coefficients_.size(); ++k)
    result.emplace_back(coefficients_[k] * static_cast<unsigned long>(k));
  return IntegerPolynomial(std::move(result));
}

/// Horner's rule for sum c_k X^k Q^(d-k), x = X / Q.
mpz_class IntegerPolynomial::scaled_value(const Rational& x) const {
  mpz_class value;
  mpz_class power = 1;
  for (std::size_t k = coefficients_.size(); k-- > 0;) {
    value *= x.get_num();
    value += coefficients_[k] * power;
    power *= x.get_den();
  }
  return value;
}

Polynomial IntegerPolynomial::to_polynomial() const {
  Polynomial result(1);
  for (int k = 0; k <= degree(); ++k)
    result.add_term({k}, Rational(coefficients_[static_cast<std::size_t>(k)]));
  return result;
}

IntegerPolynomial operator*(const IntegerPolynomial& a, const IntegerPolynomial& b) {
  if (a.is_zero() || b.is_zero()) return {};
  std::vector<mpz_class> result(a.coefficients().size() + b.coefficients().size() - 1);
  for (std::size_t i = 0; i < a.coefficients().size(); ++i) {
    for (std::size_t k = 0; k < b.coefficients().size(); ++k)
      result[i + k] += a.coefficients()[i] * b.coefficients()[k];
  }
  return IntegerPolynomial(std::move(result));
}

IntegerPolynomial operator-(const IntegerPolynomial& a, const IntegerPolynomial& b) {
  std::vector<mpz_class> result = a.coefficients();
  result.resize(std::max(result.size(), b.coefficients().size()));
  for (std::size_t k = 0; k < b.coefficients().size(); ++k) result[k] -= b.coefficients()[k];
  return IntegerPolynomial(std::move(result));
}

IntegerPolynomial exact_quotient(const IntegerPolynomial& a, const IntegerPolynomial& b) {
  GCSLAB_CHECK(!b.is_zero());
  std::vector<mpz_class> rest = a.coefficients();
  const std::size_t length = b.coefficients().size();
  if (rest.size() < length) {
    GCSLAB_CHECK(rest.empty());
    return {};
  }
  std::vector<mpz_class> quotient(rest.size() - length + 1);
  for (std::size_t k = quotient.size(); k-- > 0;) {
    const mpz_class& top = rest[k + length - 1];
    GCSLAB_CHECK(mpz_divisible_p(top.get_mpz_t(), b.leading().get_mpz_t()) != 0);
    mpz_divexact(quotient[k].get_mpz_t(), top.get_mpz_t(), b.leading().get_mpz_t());
    for (std::size_t i = 0; i < length; ++i) rest[k + i] -= quotient[k] * b.coefficients()[i];
  }
  GCSLAB_CHECK(IntegerPolynomial(std::move(rest)).is_zero());
  return IntegerPolynomial(std::move(quotient));
}

IntegerPolynomial primitive_part(const IntegerPolynomial& a) {
  if (a.is_zero()) return a;
  mpz_class divisor = content(a);
  if (a.leading() < 0) divisor = -divisor;
  if (divisor == 1) return a;
  std::vector<mpz_class> result = a.coefficients();
  for (mpz_class& c : result) mpz_divexact(c.get_mpz_t(), c.get_mpz_t(), divisor.get_mpz_t());
  return IntegerPolynomial(std::move(result));
}

IntegerPolynomial primitive_polynomial(const Polynomial& polynomial) {
  GCSLAB_CHECK(polynomial.variables() == 1);
  mpz_class denominator = 1;
  for (const auto& [exponents, coefficient] : polynomial.terms())
    denominator = lcm(denominator, coefficient.get_den());
  std::vector<mpz_class> coefficients(static_cast<std::size_t>(polynomial.total_degree()) + 1);
  for (const auto& [exponents, coefficient] : polynomial.terms()) {
    coefficients[static_cast<std::size_t>(exponents[0])] =
        coefficient.get_num() * (denominator / coefficient.get_den());
  }
  return primitive_part(IntegerPolynomial(std::move(coefficients)));
}

SignEvaluator::SignEvaluator(IntegerPolynomial polynomial)
    : polynomial_(std::move(polynomial)), enclosures_(enclosures(polynomial_)) {}

int SignEvaluator::sign(const Rational& x) const {
  {
    const NumberTraits<FastInterval>::Scope scope;
    const FastInterval point = NumberTraits<FastInterval>::from_rational(x);
    FastInterval value(0.0);
    for (std::size_t k = enclosures_.size(); k-- > 0;) value = value * point + enclosures_[k];
    if (value.lower() > 0) return 1;
    if (value.upper() < 0) return -1;
  }
  return sgn(polynomial_.scaled_value(x));
}

}  // namespace gcslab
