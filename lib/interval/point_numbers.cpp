#include "interval/point_numbers.h"

#include <string>

#include "base/error.h"
#include "interval/elementary.h"

namespace gcslab {
namespace {

[[noreturn]] void no_exact(const char* function) {
  throw NotApplicable(std::string("exact rational arithmetic has no ") + function);
}

Rational positive_power(const Rational& x, unsigned long n) {
  Rational power;
  mpz_pow_ui(power.get_num_mpz_t(), x.get_num_mpz_t(), n);
  mpz_pow_ui(power.get_den_mpz_t(), x.get_den_mpz_t(), n);
  return power;  // powers of coprime numbers are coprime
}

}  // namespace

double pow(double x, const Rational& exponent) {
  if (exponent.get_den() == 1 && exponent.get_num().fits_sint_p()) {
    return pow(x, static_cast<int>(exponent.get_num().get_si()));
  }
  const double power = std::pow(std::fabs(x), exponent.get_d());
  if (x >= 0) return power;
  if (mpz_even_p(exponent.get_den_mpz_t())) return std::numeric_limits<double>::quiet_NaN();
  return mpz_even_p(exponent.get_num_mpz_t()) ? power : -power;
}

float pow(float x, const Rational& exponent) {
  return static_cast<float>(pow(static_cast<double>(x), exponent));
}

Rational sqr(const Rational& x) { return x * x; }

Rational pow(const Rational& x, int n) {
  if (n >= 0) return positive_power(x, static_cast<unsigned long>(n));
  return divide(1, positive_power(x, static_cast<unsigned long>(-static_cast<long>(n))));
}

Rational pow(const Rational& x, const Rational& exponent) {
  if (exponent.get_den() != 1 || !exponent.get_num().fits_sint_p()) no_exact("roots");
  return pow(x, static_cast<int>(exponent.get_num().get_si()));
}

Rational abs(const Rational& x) { return x < 0 ? Rational(-x) : x; }
Rational min(const Rational& x, const Rational& y) { return y < x ? y : x; }
Rational max(const Rational& x, const Rational& y) { return x < y ? y : x; }

Rational divide(const Rational& x, const Rational& y) {
  if (y == 0) throw NotApplicable("exact rational arithmetic met a division by zero");
  return x / y;
}

Rational sign_enclosure(const Rational& x) { return sgn(x); }
Rational less_enclosure(const Rational& x, const Rational& y) { return x < y ? 1 : 0; }

Rational sqrt(const Rational&) { no_exact("sqrt"); }
Rational cbrt(const Rational&) { no_exact("cbrt"); }
Rational exp(const Rational&) { no_exact("exp"); }
Rational log(const Rational&) { no_exact("log"); }
Rational sin(const Rational&) { no_exact("sin"); }
Rational cos(const Rational&) { no_exact("cos"); }
Rational tan(const Rational&) { no_exact("tan"); }
Rational asin(const Rational&) { no_exact("asin"); }
Rational acos(const Rational&) { no_exact("acos"); }
Rational atan(const Rational&) { no_exact("atan"); }

Interval NumberTraits<double>::enclosure(double x) {
  if (std::isfinite(x)) return x;
  constexpr double kLargest = std::numeric_limits<double>::max();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  if (x > 0) return {kLargest, kInfinity};
  if (x < 0) return {-kInfinity, -kLargest};
  return Interval::empty();
}

float NumberTraits<float>::from_rational(const Rational& value) {
  const NearestRounding nearest;
  return static_cast<float>(nearest_double(value));
}

Rational NumberTraits<Rational>::pi() { no_exact("pi"); }
Interval NumberTraits<Rational>::enclosure(const Rational& x) { return elementary::enclosing(x); }

}  // namespace gcslab
