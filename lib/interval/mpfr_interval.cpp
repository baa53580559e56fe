#include "interval/mpfr_interval.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "base/check.h"
#include "interval/quadrant.h"

namespace gcslab {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Bits that a root has beyond the result's, so that a power of it up to 2^31 is still accurate.
constexpr mpfr_prec_t kGuardBits = 107;

thread_local mpfr_prec_t active_precision = 53;

using Unary = int (*)(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t);
using Binary = int (*)(mpfr_ptr, mpfr_srcptr, mpfr_srcptr, mpfr_rnd_t);

MpfrNumber number(double value) {
  MpfrNumber result;
  mpfr_set_d(result.get(), value, MPFR_RNDN);
  return result;
}

MpfrNumber rounded(Unary f, mpfr_srcptr x, mpfr_rnd_t rounding) {
  MpfrNumber result;
  f(result.get(), x, rounding);
  return result;
}

MpfrNumber rounded(Binary f, mpfr_srcptr x, mpfr_srcptr y, mpfr_rnd_t rounding) {
  MpfrNumber result;
  f(result.get(), x, y, rounding);
  return result;
}

/// The product of two ends, where 0 * inf is 0.
MpfrNumber product(mpfr_srcptr x, mpfr_srcptr y, mpfr_rnd_t rounding) {
  if (mpfr_zero_p(x) || mpfr_zero_p(y)) return number(0);
  return rounded(mpfr_mul, x, y, rounding);
}

/// The quotient of two ends, y a bound from above of divisors or a limit of positive ones.
MpfrNumber quotient(mpfr_srcptr x, mpfr_srcptr y, mpfr_rnd_t rounding) {
  if (mpfr_zero_p(x)) return number(0);
  if (mpfr_zero_p(y)) return number(mpfr_sgn(x) > 0 ? kInfinity : -kInfinity);
  return rounded(mpfr_div, x, y, rounding);
}

MpfrInterval interval_of(double lower, double upper) { return {number(lower), number(upper)}; }
MpfrInterval empty_interval() { return interval_of(kInfinity, -kInfinity); }
MpfrInterval entire_interval() { return interval_of(-kInfinity, kInfinity); }

/// Both roundings of f(x), from one correctly rounded evaluation.
MpfrInterval at(Unary f, mpfr_srcptr x) {
  MpfrNumber lower;
  const int ternary = f(lower.get(), x, MPFR_RNDD);
  MpfrNumber upper = lower;
  if (ternary != 0) mpfr_nextabove(upper.get());
  return {std::move(lower), std::move(upper)};
}

MpfrInterval increasing(Unary f, mpfr_srcptr lower, mpfr_srcptr upper) {
  return {rounded(f, lower, MPFR_RNDD), rounded(f, upper, MPFR_RNDU)};
}

MpfrInterval increasing(Unary f, const MpfrInterval& x) {
  return x.is_empty() ? x : increasing(f, x.lower(), x.upper());
}

/// sin or cos, whose maxima and minima lie at the multiples k pi/2 with k = maximum or minimum modulo 4.
MpfrInterval periodic(Unary f, int maximum, int minimum, const MpfrInterval& x) {
  if (x.is_empty()) return x;
  if (!mpfr_number_p(x.lower()) || !mpfr_number_p(x.upper())) return interval_of(-1, 1);
  const elementary::QuadrantSpan span = elementary::quadrant_span(x.lower(), x.upper());
  const bool reaches_top = span.crosses(maximum);
  const bool reaches_bottom = span.crosses(minimum);
  if (reaches_top && reaches_bottom) return interval_of(-1, 1);
  const MpfrInterval low = at(f, x.lower());
  const MpfrInterval high = at(f, x.upper());
  return {reaches_bottom ? number(-1) : rounded(mpfr_min, low.lower(), high.lower(), MPFR_RNDD),
          reaches_top ? number(1) : rounded(mpfr_max, low.upper(), high.upper(), MPFR_RNDU)};
}

/// The part of x in [lower, upper].
MpfrInterval cut(const MpfrInterval& x, double lower, double upper) {
  if (x.is_empty() || mpfr_cmp_d(x.upper(), lower) < 0 || mpfr_cmp_d(x.lower(), upper) > 0)
    return empty_interval();
  return {mpfr_cmp_d(x.lower(), lower) < 0 ? number(lower) : MpfrNumber(x.lower()),
          mpfr_cmp_d(x.upper(), upper) > 0 ? number(upper) : MpfrNumber(x.upper())};
}

mpfr_rnd_t opposite(mpfr_rnd_t rounding) { return rounding == MPFR_RNDD ? MPFR_RNDU : MPFR_RNDD; }

MpfrInterval hull(const MpfrInterval& x, const MpfrInterval& y) {
  return {rounded(mpfr_min, x.lower(), y.lower(), MPFR_RNDD),
          rounded(mpfr_max, x.upper(), y.upper(), MPFR_RNDU)};
}

/// t^(p/q) for 0 < t < inf; as in elementary.cpp.
void power_by_root(mpfr_ptr result, mpfr_srcptr t, long p, unsigned long q, mpfr_rnd_t rounding) {
  MpfrNumber root(active_precision + kGuardBits);
  mpfr_rootn_ui(root.get(), t, q, p < 0 ? opposite(rounding) : rounding);
  mpfr_pow_si(result, root.get(), p, rounding);
}

void power_by_exponent(mpfr_ptr result, mpfr_srcptr t, const Rational& exponent, mpfr_rnd_t rounding) {
  MpfrNumber rounded_exponent(active_precision + kGuardBits);
  mpfr_set_q(rounded_exponent.get(), exponent.get_mpq_t(),
             mpfr_cmp_ui(t, 1) >= 0 ? rounding : opposite(rounding));
  mpfr_pow(result, t, rounded_exponent.get(), rounding);
}

bool is_small(const Rational& exponent) {
  constexpr long kSmall = std::numeric_limits<int>::max();
  return ::abs(exponent.get_num()) <= kSmall && exponent.get_den() <= kSmall;
}

/// A power function on the nonnegative numbers, and what it is on the others.
struct PowerRule {
  bool grows;             ///< exponent > 0
  bool even_numerator;    ///< f(-t) = f(t), otherwise f(-t) = -f(t)
  bool even_denominator;  ///< not defined for negative numbers
};

/// The interval extension of the power function that evaluate(result, t, rounding) computes for 0 < t < inf.
template <class Evaluate>
class PowerExtension {
 public:
  PowerExtension(PowerRule rule, Evaluate evaluate) : rule_(rule), evaluate_(std::move(evaluate)) {}

  MpfrInterval operator()(const MpfrInterval& x) const {
    MpfrInterval right = on_nonnegative(cut(x, 0, kInfinity));
    if (rule_.even_denominator || mpfr_sgn(x.lower()) >= 0) return right;
    const MpfrInterval left = on_nonnegative(-cut(x, -kInfinity, 0));
    return hull(right, rule_.even_numerator ? left : -left);
  }

 private:
  MpfrNumber at(mpfr_srcptr t, mpfr_rnd_t rounding) const {
    if (mpfr_zero_p(t)) return number(rule_.grows ? 0 : kInfinity);
    if (mpfr_inf_p(t)) return number(rule_.grows ? kInfinity : 0);
    MpfrNumber result;
    evaluate_(result.get(), t, rounding);
    return result;
  }

  MpfrInterval on_nonnegative(const MpfrInterval& x) const {
    if (x.is_empty() || (!rule_.grows && mpfr_zero_p(x.upper()))) return empty_interval();
    return {at(rule_.grows ? x.lower() : x.upper(), MPFR_RNDD),
            at(rule_.grows ? x.upper() : x.lower(), MPFR_RNDU)};
  }

  PowerRule rule_;
  Evaluate evaluate_;
};

/// x / y for y without negative members, not [0, 0].
MpfrInterval divide_by_nonnegative(const MpfrInterval& x, const MpfrInterval& y) {
  return {quotient(x.lower(), mpfr_sgn(x.lower()) >= 0 ? y.upper() : y.lower(), MPFR_RNDD),
          quotient(x.upper(), mpfr_sgn(x.upper()) > 0 ? y.lower() : y.upper(), MPFR_RNDU)};
}

/// x * y for x whose members have both signs.
MpfrInterval multiply_straddling(const MpfrInterval& x, const MpfrInterval& y) {
  if (mpfr_sgn(y.lower()) >= 0) {
    return {product(x.lower(), y.upper(), MPFR_RNDD), product(x.upper(), y.upper(), MPFR_RNDU)};
  }
  if (mpfr_sgn(y.upper()) <= 0) {
    return {product(x.upper(), y.lower(), MPFR_RNDD), product(x.lower(), y.lower(), MPFR_RNDU)};
  }
  const MpfrInterval left(product(x.lower(), y.upper(), MPFR_RNDD), product(x.lower(), y.lower(), MPFR_RNDU));
  const MpfrInterval right(product(x.upper(), y.lower(), MPFR_RNDD),
                           product(x.upper(), y.upper(), MPFR_RNDU));
  return hull(left, right);
}

MpfrInterval multiply_nonnegative(const MpfrInterval& x, const MpfrInterval& y) {
  return {product(mpfr_sgn(y.lower()) >= 0 ? x.lower() : x.upper(), y.lower(), MPFR_RNDD),
          product(mpfr_sgn(y.upper()) >= 0 ? x.upper() : x.lower(), y.upper(), MPFR_RNDU)};
}

}  // namespace

MpfrNumber::MpfrNumber() : MpfrNumber(active_precision) {}
MpfrNumber::MpfrNumber(mpfr_prec_t precision) { mpfr_init2(value_, precision); }

MpfrNumber::MpfrNumber(mpfr_srcptr value) : MpfrNumber(mpfr_get_prec(value)) {
  mpfr_set(value_, value, MPFR_RNDN);  // exact: the precision is the same
}

MpfrNumber::MpfrNumber(const MpfrNumber& other) : MpfrNumber(other.get()) {}

MpfrNumber::MpfrNumber(MpfrNumber&& other) noexcept {
  *value_ = *other.value_;
  other.value_->_mpfr_d = nullptr;
}

MpfrNumber& MpfrNumber::operator=(MpfrNumber other) noexcept {
  std::swap(*value_, *other.value_);
  return *this;
}

MpfrNumber::~MpfrNumber() {
  if (value_->_mpfr_d != nullptr) mpfr_clear(value_);
}

MpfrInterval::MpfrInterval(const Interval& x) {
  mpfr_set_d(lower_.get(), x.lower, MPFR_RNDD);
  mpfr_set_d(upper_.get(), x.upper, MPFR_RNDU);
}

Interval MpfrInterval::interval() const {
  if (is_empty()) return Interval::empty();
  return {mpfr_get_d(lower(), MPFR_RNDD) + 0.0, mpfr_get_d(upper(), MPFR_RNDU) + 0.0};  // no -0
}

MpfrInterval operator-(const MpfrInterval& x) {
  return {rounded(mpfr_neg, x.upper(), MPFR_RNDD), rounded(mpfr_neg, x.lower(), MPFR_RNDU)};
}

MpfrInterval operator+(const MpfrInterval& x, const MpfrInterval& y) {
  if (x.is_empty() || y.is_empty()) return empty_interval();
  return {rounded(mpfr_add, x.lower(), y.lower(), MPFR_RNDD),
          rounded(mpfr_add, x.upper(), y.upper(), MPFR_RNDU)};
}

MpfrInterval operator-(const MpfrInterval& x, const MpfrInterval& y) {
  if (x.is_empty() || y.is_empty()) return empty_interval();
  return {rounded(mpfr_sub, x.lower(), y.upper(), MPFR_RNDD),
          rounded(mpfr_sub, x.upper(), y.lower(), MPFR_RNDU)};
}

MpfrInterval operator*(const MpfrInterval& x, const MpfrInterval& y) {
  if (x.is_empty() || y.is_empty()) return empty_interval();
  if (mpfr_sgn(x.lower()) >= 0) return multiply_nonnegative(x, y);
  if (mpfr_sgn(x.upper()) <= 0) return -multiply_nonnegative(-x, y);
  return multiply_straddling(x, y);
}

MpfrInterval operator/(const MpfrInterval& x, const MpfrInterval& y) {
  if (x.is_empty() || y.is_empty()) return empty_interval();
  const int lower_sign = mpfr_sgn(y.lower());
  const int upper_sign = mpfr_sgn(y.upper());
  if (lower_sign == 0 && upper_sign == 0) return empty_interval();
  if (mpfr_zero_p(x.lower()) && mpfr_zero_p(x.upper())) return x;
  if (lower_sign < 0 && upper_sign > 0) return entire_interval();
  return lower_sign >= 0 ? divide_by_nonnegative(x, y) : -divide_by_nonnegative(x, -y);
}

MpfrInterval sqr(const MpfrInterval& x) {
  const MpfrInterval size = abs(x);
  return size.is_empty() ? size : increasing(mpfr_sqr, size);
}

MpfrInterval pow(const MpfrInterval& x, int n) {
  if (n == 2) return sqr(x);
  if (n == 0 && !x.is_empty()) return interval_of(1, 1);
  const PowerRule rule{.grows = n > 0, .even_numerator = n % 2 == 0, .even_denominator = false};
  return PowerExtension(rule, [n](mpfr_ptr result, mpfr_srcptr t, mpfr_rnd_t rounding) {
    mpfr_pow_si(result, t, n, rounding);
  })(x);
}

MpfrInterval pow(const MpfrInterval& x, const Rational& exponent) {
  const bool small = is_small(exponent);
  if (exponent.get_den() == 1 && small) return pow(x, static_cast<int>(exponent.get_num().get_si()));
  const PowerRule rule{.grows = exponent > 0,
                       .even_numerator = mpz_even_p(exponent.get_num_mpz_t()) != 0,
                       .even_denominator = mpz_even_p(exponent.get_den_mpz_t()) != 0};
  return PowerExtension(rule, [&](mpfr_ptr result, mpfr_srcptr t, mpfr_rnd_t rounding) {
    if (!small) return power_by_exponent(result, t, exponent, rounding);
    power_by_root(result, t, exponent.get_num().get_si(), exponent.get_den().get_ui(), rounding);
  })(x);
}

MpfrInterval sqrt(const MpfrInterval& x) { return increasing(mpfr_sqrt, cut(x, 0, kInfinity)); }
MpfrInterval cbrt(const MpfrInterval& x) { return increasing(mpfr_cbrt, x); }
MpfrInterval exp(const MpfrInterval& x) { return increasing(mpfr_exp, x); }

MpfrInterval log(const MpfrInterval& x) {
  if (x.is_empty() || mpfr_sgn(x.upper()) <= 0) return empty_interval();
  return increasing(mpfr_log, cut(x, 0, kInfinity));
}

MpfrInterval sin(const MpfrInterval& x) { return periodic(mpfr_sin, 1, 3, x); }
MpfrInterval cos(const MpfrInterval& x) { return periodic(mpfr_cos, 0, 2, x); }

MpfrInterval tan(const MpfrInterval& x) {
  if (x.is_empty()) return x;
  if (!mpfr_number_p(x.lower()) || !mpfr_number_p(x.upper())) return entire_interval();
  if (elementary::quadrant_span(x.lower(), x.upper()).crosses_odd()) return entire_interval();
  return increasing(mpfr_tan, x);
}

MpfrInterval asin(const MpfrInterval& x) { return increasing(mpfr_asin, cut(x, -1, 1)); }

MpfrInterval acos(const MpfrInterval& x) {
  const MpfrInterval domain = cut(x, -1, 1);
  return domain.is_empty() ? domain
                           : MpfrInterval(rounded(mpfr_acos, domain.upper(), MPFR_RNDD),
                                          rounded(mpfr_acos, domain.lower(), MPFR_RNDU));
}

MpfrInterval atan(const MpfrInterval& x) { return increasing(mpfr_atan, x); }

MpfrInterval abs(const MpfrInterval& x) {
  if (x.is_empty() || mpfr_sgn(x.lower()) >= 0) return x;
  MpfrInterval mirrored = -x;
  if (mpfr_sgn(x.upper()) <= 0) return mirrored;
  return {number(0), rounded(mpfr_max, x.upper(), mirrored.upper(), MPFR_RNDU)};
}

MpfrInterval min(const MpfrInterval& x, const MpfrInterval& y) {
  if (x.is_empty() || y.is_empty()) return empty_interval();
  return {rounded(mpfr_min, x.lower(), y.lower(), MPFR_RNDD),
          rounded(mpfr_min, x.upper(), y.upper(), MPFR_RNDU)};
}

MpfrInterval max(const MpfrInterval& x, const MpfrInterval& y) {
  if (x.is_empty() || y.is_empty()) return empty_interval();
  return {rounded(mpfr_max, x.lower(), y.lower(), MPFR_RNDD),
          rounded(mpfr_max, x.upper(), y.upper(), MPFR_RNDU)};
}

NumberTraits<MpfrInterval>::Scope::Scope(int bits) : saved_(active_precision) {
  GCSLAB_CHECK(bits >= 2);
  active_precision = bits;
}

NumberTraits<MpfrInterval>::Scope::~Scope() { active_precision = saved_; }

MpfrInterval NumberTraits<MpfrInterval>::from_rational(const Rational& value) {
  MpfrNumber lower;
  MpfrNumber upper;
  mpfr_set_q(lower.get(), value.get_mpq_t(), MPFR_RNDD);
  mpfr_set_q(upper.get(), value.get_mpq_t(), MPFR_RNDU);
  return {std::move(lower), std::move(upper)};
}

MpfrInterval NumberTraits<MpfrInterval>::pi() {
  MpfrNumber lower;
  MpfrNumber upper;
  mpfr_const_pi(lower.get(), MPFR_RNDD);
  mpfr_const_pi(upper.get(), MPFR_RNDU);
  return {std::move(lower), std::move(upper)};
}

}  // namespace gcslab
