#include "verifier/integer_polynomial.h"

#include <cmath>
#include <flint/fmpq.h>
#include <gmpxx.h>

#include "base/check.h"

namespace gcslab::verifier {

IntegerPolynomial::IntegerPolynomial(const PolynomialTerms& terms) : IntegerPolynomial() {
  mpz_class denominator = 1;
  for (const auto& [exponents, c] : terms) denominator = lcm(denominator, c.get_den());
  for (const auto& [exponents, c] : terms) {
    const mpz_class coefficient = c.get_num() * (denominator / c.get_den());
    fmpz_poly_set_coeff_mpz(value_, exponents.at(0), coefficient.get_mpz_t());
  }
  make_primitive();
}

/// Divided by the common factor of the coefficients, which is positive: no sign changes.
void IntegerPolynomial::make_primitive() {
  if (is_zero()) return;
  fmpz_t common;
  fmpz_init(common);
  fmpz_poly_content(common, value_);
  fmpz_poly_scalar_divexact_fmpz(value_, value_, common);
  fmpz_clear(common);
}

int IntegerPolynomial::sign_of_leading_coefficient() const {
  return is_zero() ? 0 : fmpz_sgn(fmpz_poly_lead(value_));
}

int IntegerPolynomial::sign_at(double x) const {
  if (std::isinf(x))
    return x < 0 && degree() % 2 != 0 ? -sign_of_leading_coefficient() : sign_of_leading_coefficient();
  fmpq_t point, value;
  fmpq_init(point);
  fmpq_init(value);
  fmpq_set_mpq(point, Rational(x).get_mpq_t());
  fmpz_poly_evaluate_fmpq(value, value_, point);
  const int sign = fmpq_sgn(value);
  fmpq_clear(value);
  fmpq_clear(point);
  return sign;
}

IntegerPolynomial IntegerPolynomial::derivative() const {
  IntegerPolynomial result;
  fmpz_poly_derivative(result.value_, value_);
  result.make_primitive();
  return result;
}

/// c^d this = q divisor + r with c the divisor's leading coefficient.
IntegerPolynomial IntegerPolynomial::negative_remainder(const IntegerPolynomial& divisor) const {
  IntegerPolynomial result;
  ulong power = 0;
  fmpz_poly_pseudo_rem(result.value_, &power, value_, divisor.value_);
  const bool is_flipped = divisor.sign_of_leading_coefficient() < 0 && power % 2 != 0;
  if (!is_flipped) fmpz_poly_neg(result.value_, result.value_);
  result.make_primitive();
  return result;
}

IntegerPolynomial IntegerPolynomial::quotient(const IntegerPolynomial& divisor) const {
  IntegerPolynomial result;
  GCSLAB_CHECK(fmpz_poly_divides(result.value_, value_, divisor.value_) != 0);
  return result;
}

}  // namespace gcslab::verifier
