#include "univariate/root_interval.h"

#include <algorithm>

#include "base/check.h"

namespace gcslab {
namespace {

/// The sign just right of x: the derivative's where x is a simple root.
int sign_after(const SignEvaluator& signs, const Rational& x) {
  const int sign = signs.sign(x);
  return sign != 0 ? sign : sgn(signs.polynomial().derivative().scaled_value(x));
}

Rational value(const IntegerPolynomial& polynomial, const Rational& x) {
  mpz_class denominator;
  mpz_pow_ui(denominator.get_mpz_t(), x.get_den_mpz_t(), static_cast<unsigned long>(polynomial.degree()));
  Rational result(polynomial.scaled_value(x), denominator);
  result.canonicalize();
  return result;
}

/// The integer nearest to x.
mpz_class nearest_integer(const Rational& x) {
  const Rational moved = x + Rational(1, 2);
  mpz_class result;
  mpz_fdiv_q(result.get_mpz_t(), moved.get_num_mpz_t(), moved.get_den_mpz_t());
  return result;
}

/// The least number of bits, at least 1, with 2^bits >= ratio.
unsigned long bits_wanted(const Rational& ratio) {
  mpz_class whole;
  mpz_cdiv_q(whole.get_mpz_t(), ratio.get_num_mpz_t(), ratio.get_den_mpz_t());
  return std::max<unsigned long>(mpz_sizeinbase(mpz_class(whole - 1).get_mpz_t(), 2), 1);
}

}  // namespace

RootInterval::RootInterval(const SignEvaluator& signs, Rational lower, Rational upper)
    : signs_(&signs), lower_(std::move(lower)), upper_(std::move(upper)), sign_after_lower_(0) {
  if (lower_ < upper_) sign_after_lower_ = sign_after(signs, lower_);
}

void RootInterval::cut(const Rational& x) {
  GCSLAB_CHECK(lower_ < x && x < upper_);
  const int sign = signs_->sign(x);
  if (sign == 0) {
    lower_ = upper_ = x;
  } else {
    (sign == sign_after_lower_ ? lower_ : upper_) = x;
  }
}

bool RootInterval::take_part(unsigned long bits) {
  const Rational at_lower = value(signs_->polynomial(), lower_);
  const Rational at_upper = value(signs_->polynomial(), upper_);
  if (at_lower == 0 || at_upper == 0 || sgn(at_lower) == sgn(at_upper)) {  // an end is another root
    bisect();
    return false;
  }
  mpz_class parts = 1;
  parts <<= bits;
  const mpz_class guess = nearest_integer(parts * at_lower / (at_lower - at_upper));
  const Rational step = width() / parts;
  const Rational end = upper_;
  const Rational point = lower_ + guess * step;
  if (lower_ < point && point < end) cut(point);
  if (lower_ == upper_) return true;
  const Rational other = point + (upper_ == point ? Rational(-step) : step);
  if (lower_ < other && other < upper_) cut(other);
  return width() <= step;
}

void RootInterval::refine(const Rational& width) {
  GCSLAB_CHECK(width > 0);
  unsigned long bits = 2;
  while (this->width() > width) {
    bits = std::min(bits, bits_wanted(this->width() / width));
    if (take_part(bits)) {
      bits *= 2;
    } else if (bits > 1) {
      bits /= 2;
    } else {
      bisect();
    }
  }
}

}  // namespace gcslab
