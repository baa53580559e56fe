#pragma once

// Polynomials in one variable with integer coefficients, dense and exact.
//
// What is said of roots does not change when a rational polynomial is multiplied by a common denominator, so
// that integers suffice. A polynomial is primitive when its coefficients have no common factor and the
// leading one is positive.

#include <gmpxx.h>
#include <span>
#include <vector>

#include "interval/fast_interval.h"
#include "polynomial/polynomial.h"

namespace gcslab {

class IntegerPolynomial {
 public:
  /// Zero.
  IntegerPolynomial() = default;
  /// sum coefficients[k] x^k.
  explicit IntegerPolynomial(std::vector<mpz_class> coefficients);

  /// By ascending powers; the last one is not 0.
  const std::vector<mpz_class>& coefficients() const { return coefficients_; }
  /// -1 for zero.
  int degree() const { return static_cast<int>(coefficients_.size()) - 1; }
  bool is_zero() const { return coefficients_.empty(); }
  const mpz_class& leading() const { return coefficients_.back(); }

  IntegerPolynomial derivative() const;
  /// The exact value times denominator^degree, for x in lowest terms; hence of the value's sign.
  mpz_class scaled_value(const Rational& x) const;
  /// The same as a sparse polynomial in one variable.
  Polynomial to_polynomial() const;

  friend bool operator==(const IntegerPolynomial&, const IntegerPolynomial&) = default;

 private:
  std::vector<mpz_class> coefficients_;
};

IntegerPolynomial operator*(const IntegerPolynomial& a, const IntegerPolynomial& b);
IntegerPolynomial operator-(const IntegerPolynomial& a, const IntegerPolynomial& b);
/// a / b, which must be a polynomial with integer coefficients.
IntegerPolynomial exact_quotient(const IntegerPolynomial& a, const IntegerPolynomial& b);
/// The primitive polynomial with the same roots; zero for zero.
IntegerPolynomial primitive_part(const IntegerPolynomial& a);
/// The primitive polynomial with the roots of a polynomial in one variable.
IntegerPolynomial primitive_polynomial(const Polynomial& polynomial);

/// Signs of one polynomial at many points: in double intervals, and exactly where these contain 0.
class SignEvaluator {
 public:
  explicit SignEvaluator(IntegerPolynomial polynomial);

  const IntegerPolynomial& polynomial() const { return polynomial_; }
  /// -1, 0 or 1.
  int sign(const Rational& x) const;

 private:
  IntegerPolynomial polynomial_;
  std::vector<FastInterval> enclosures_;  ///< of the coefficients
};

}  // namespace gcslab
