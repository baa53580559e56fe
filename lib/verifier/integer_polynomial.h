#pragma once

// Polynomials in one variable with integer coefficients, by FLINT (fmpz_poly).

#include <flint/fmpz_poly.h>

#include "verifier/polynomial_terms.h"

namespace gcslab::verifier {

class IntegerPolynomial {
 public:
  /// Zero.
  IntegerPolynomial() { fmpz_poly_init(value_); }
  IntegerPolynomial(const IntegerPolynomial& other) : IntegerPolynomial() { *this = other; }
  IntegerPolynomial(IntegerPolynomial&& other) noexcept : IntegerPolynomial() { swap(other); }
  IntegerPolynomial& operator=(const IntegerPolynomial& other) {
    fmpz_poly_set(value_, other.value_);
    return *this;
  }
  IntegerPolynomial& operator=(IntegerPolynomial&& other) noexcept {
    swap(other);
    return *this;
  }
  ~IntegerPolynomial() { fmpz_poly_clear(value_); }

  /// The primitive one that is a positive multiple of the terms, which are in one variable.
  explicit IntegerPolynomial(const PolynomialTerms& terms);

  bool is_zero() const { return fmpz_poly_is_zero(value_) != 0; }
  int degree() const { return static_cast<int>(fmpz_poly_degree(value_)); }
  int sign_of_leading_coefficient() const;
  /// At a number or at +-inf.
  int sign_at(double x) const;

  /// Positive multiples, with coefficients that have no common factor.
  IntegerPolynomial derivative() const;
  /// Of -(this modulo divisor), which is not 0.
  IntegerPolynomial negative_remainder(const IntegerPolynomial& divisor) const;
  /// this / divisor, which divides it.
  IntegerPolynomial quotient(const IntegerPolynomial& divisor) const;

 private:
  void swap(IntegerPolynomial& other) noexcept { fmpz_poly_swap(value_, other.value_); }
  void make_primitive();

  fmpz_poly_t value_;
};

}  // namespace gcslab::verifier
