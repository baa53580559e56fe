#include "verifier/range.h"

#include <limits>

#include "base/check.h"

namespace gcslab::verifier {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

using Unary = int (*)(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t);

mpfr_rnd_t opposite(mpfr_rnd_t rounding) { return rounding == MPFR_RNDD ? MPFR_RNDU : MPFR_RNDD; }

/// The product of two ends, where 0 * inf is 0.
void multiply_ends(mpfr_ptr result, mpfr_srcptr x, mpfr_srcptr y, mpfr_rnd_t rounding) {
  if (mpfr_zero_p(x) != 0 || mpfr_zero_p(y) != 0) {
    mpfr_set_zero(result, 1);
  } else {
    mpfr_mul(result, x, y, rounding);
  }
}

/// The quotient of two ends, where y = 0 is the limit of positive numbers.
void divide_ends(mpfr_ptr result, mpfr_srcptr x, mpfr_srcptr y, mpfr_rnd_t rounding) {
  if (mpfr_zero_p(x) != 0) {
    mpfr_set_zero(result, 1);
  } else if (mpfr_zero_p(y) != 0) {
    mpfr_set_inf(result, mpfr_sgn(x));
  } else {
    mpfr_div(result, x, y, rounding);
  }
}

/// x * y for x without negative members.
Range multiply_nonnegative(const Range& x, const Range& y) {
  Range result;
  multiply_ends(result.lower(), mpfr_sgn(y.lower()) >= 0 ? x.lower() : x.upper(), y.lower(), MPFR_RNDD);
  multiply_ends(result.upper(), mpfr_sgn(y.upper()) >= 0 ? x.upper() : x.lower(), y.upper(), MPFR_RNDU);
  return result;
}

/// x * y where both have members of both signs.
Range multiply_straddling(const Range& x, const Range& y) {
  Range result;
  Range other;
  multiply_ends(result.lower(), x.lower(), y.upper(), MPFR_RNDD);
  multiply_ends(other.lower(), x.upper(), y.lower(), MPFR_RNDD);
  multiply_ends(result.upper(), x.lower(), y.lower(), MPFR_RNDU);
  multiply_ends(other.upper(), x.upper(), y.upper(), MPFR_RNDU);
  return hull(result, other);
}

/// x / y for y without negative members, not {0}.
Range divide_by_nonnegative(const Range& x, const Range& y) {
  Range result;
  divide_ends(result.lower(), x.lower(), mpfr_sgn(x.lower()) >= 0 ? y.upper() : y.lower(), MPFR_RNDD);
  divide_ends(result.upper(), x.upper(), mpfr_sgn(x.upper()) > 0 ? y.lower() : y.upper(), MPFR_RNDU);
  return result;
}

Range increasing(Unary f, const Range& x) {
  if (x.is_empty()) return x;
  Range result;
  f(result.lower(), x.lower(), MPFR_RNDD);
  f(result.upper(), x.upper(), MPFR_RNDU);
  return result;
}

Range nonnegative_part(const Range& x) { return intersection(x, Range(Interval(0, kInfinity))); }

/// A scratch number of any precision.
class Scratch {
 public:
  explicit Scratch(mpfr_prec_t precision) { mpfr_init2(value_, precision); }
  ~Scratch() { mpfr_clear(value_); }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  mpfr_ptr get() { return value_; }

 private:
  mpfr_t value_;
};

/// The multiples k pi/2 that may lie in a range: k from `first` to `last`. None is left out; one beside an
/// end, nearer than 2^-200, may be too many.
class QuarterTurns {
 public:
  explicit QuarterTurns(const Range& x) : all_(!x.is_bounded()) {
    constexpr mpfr_exp_t kLargestExponent = 65536;
    for (const mpfr_srcptr end : {x.lower(), x.upper()}) {
      if (!all_ && mpfr_zero_p(end) == 0 && mpfr_get_exp(end) > kLargestExponent) all_ = true;
    }
    if (all_) return;
    first_ = rounded_quotient(x.lower(), MPFR_RNDD, MPFR_RNDU);
    last_ = rounded_quotient(x.upper(), MPFR_RNDU, MPFR_RNDD);
  }

  /// Whether some k is `residue` modulo 4.
  bool meets(unsigned long residue) const {
    if (all_ || last_ - first_ >= 3) return true;
    for (mpz_class k = first_; k <= last_; ++k) {
      if (mpz_fdiv_ui(k.get_mpz_t(), 4) == residue) return true;
    }
    return false;
  }

 private:
  /// 2 x / pi bounded in the direction `bound`, then rounded to an integer in the direction `whole`.
  static mpz_class rounded_quotient(mpfr_srcptr x, mpfr_rnd_t bound, mpfr_rnd_t whole) {
    const mpfr_exp_t exponent = mpfr_zero_p(x) != 0 ? 0 : mpfr_get_exp(x);
    const mpfr_prec_t precision = kBits + 64 + (exponent > 0 ? exponent : 0);
    Scratch pi(precision);
    Scratch quotient(precision);
    mpfr_const_pi(pi.get(), mpfr_sgn(x) > 0 ? opposite(bound) : bound);
    mpfr_div(quotient.get(), x, pi.get(), bound);
    mpfr_mul_2ui(quotient.get(), quotient.get(), 1, bound);
    mpz_class result;
    mpfr_get_z(result.get_mpz_t(), quotient.get(), whole);
    return result;
  }

  bool all_;
  mpz_class first_, last_;
};

/// sin or cos, whose maxima and minima lie at the multiples k pi/2 with k = maximum or minimum modulo 4.
Range periodic(Unary f, unsigned long maximum, unsigned long minimum, const Range& x) {
  if (x.is_empty()) return x;
  const QuarterTurns turns(x);
  const bool reaches_top = turns.meets(maximum);
  const bool reaches_bottom = turns.meets(minimum);
  if (!x.is_bounded() || (reaches_top && reaches_bottom)) return Range(Interval(-1, 1));
  Range first;
  Range second;
  f(first.lower(), x.lower(), MPFR_RNDD);
  f(first.upper(), x.lower(), MPFR_RNDU);
  f(second.lower(), x.upper(), MPFR_RNDD);
  f(second.upper(), x.upper(), MPFR_RNDU);
  Range result = hull(first, second);
  if (reaches_top) mpfr_set_si(result.upper(), 1, MPFR_RNDU);
  if (reaches_bottom) mpfr_set_si(result.lower(), -1, MPFR_RNDD);
  return result;
}

/// t^(p/q) for 0 < t < inf, bounded in one direction.
void bound_power(mpfr_ptr result, mpfr_srcptr t, const Rational& exponent, mpfr_rnd_t rounding) {
  const mpz_class& p = exponent.get_num();
  const mpz_class& q = exponent.get_den();
  if (p.fits_slong_p() && q.fits_ulong_p()) {
    Real root;
    mpfr_rootn_ui(root.get(), t, q.get_ui(), p < 0 ? opposite(rounding) : rounding);
    mpfr_pow_si(result, root.get(), p.get_si(), rounding);
  } else {
    Real power;
    mpfr_set_q(power.get(), exponent.get_mpq_t(), mpfr_cmp_ui(t, 1) >= 0 ? rounding : opposite(rounding));
    mpfr_pow(result, t, power.get(), rounding);
  }
}

void bound_power_of_end(mpfr_ptr result, mpfr_srcptr t, const Rational& exponent, mpfr_rnd_t rounding) {
  const bool grows = exponent > 0;
  if (mpfr_zero_p(t) != 0) {
    grows ? mpfr_set_zero(result, 1) : mpfr_set_inf(result, 1);
  } else if (mpfr_inf_p(t) != 0) {
    grows ? mpfr_set_inf(result, 1) : mpfr_set_zero(result, 1);
  } else {
    bound_power(result, t, exponent, rounding);
  }
}

/// The power of a range without negative members; exponent != 0.
Range power_of_nonnegative(const Range& x, const Rational& exponent) {
  const bool grows = exponent > 0;
  if (x.is_empty() || (!grows && mpfr_zero_p(x.upper()) != 0)) return Range::empty();
  Range result;
  bound_power_of_end(result.lower(), grows ? x.lower() : x.upper(), exponent, MPFR_RNDD);
  bound_power_of_end(result.upper(), grows ? x.upper() : x.lower(), exponent, MPFR_RNDU);
  return result;
}

}  // namespace

Range::Range(const Rational& value) {
  mpfr_set_q(lower_.get(), value.get_mpq_t(), MPFR_RNDD);
  mpfr_set_q(upper_.get(), value.get_mpq_t(), MPFR_RNDU);
}

Range Range::pi() {
  Range result;
  mpfr_const_pi(result.lower(), MPFR_RNDD);
  mpfr_const_pi(result.upper(), MPFR_RNDU);
  return result;
}

bool Range::is_empty() const {
  GCSLAB_CHECK(mpfr_unordered_p(lower(), upper()) == 0);
  return mpfr_lessequal_p(lower(), upper()) == 0;
}

bool Range::is_within(const Interval& x) const {
  return is_empty() || (mpfr_cmp_d(lower(), x.lower) >= 0 && mpfr_cmp_d(upper(), x.upper) <= 0);
}

bool Range::is_within(const Range& x) const {
  return is_empty() || (mpfr_cmp(lower(), x.lower()) >= 0 && mpfr_cmp(upper(), x.upper()) <= 0);
}

bool Range::is_inside(const Range& x) const {
  return is_empty() || (mpfr_cmp(lower(), x.lower()) > 0 && mpfr_cmp(upper(), x.upper()) < 0);
}

bool Range::is_disjoint_from(const Range& x) const { return intersection(*this, x).is_empty(); }

Interval Range::outward() const {
  if (is_empty()) return Interval::empty();
  return {mpfr_get_d(lower(), MPFR_RNDD), mpfr_get_d(upper(), MPFR_RNDU)};
}

Range operator-(const Range& x) {
  Range result;
  mpfr_neg(result.lower(), x.upper(), MPFR_RNDD);
  mpfr_neg(result.upper(), x.lower(), MPFR_RNDU);
  return result;
}

Range operator+(const Range& x, const Range& y) {
  if (x.is_empty() || y.is_empty()) return Range::empty();
  Range result;
  mpfr_add(result.lower(), x.lower(), y.lower(), MPFR_RNDD);
  mpfr_add(result.upper(), x.upper(), y.upper(), MPFR_RNDU);
  return result;
}

Range operator-(const Range& x, const Range& y) {
  if (x.is_empty() || y.is_empty()) return Range::empty();
  Range result;
  mpfr_sub(result.lower(), x.lower(), y.upper(), MPFR_RNDD);
  mpfr_sub(result.upper(), x.upper(), y.lower(), MPFR_RNDU);
  return result;
}

Range operator*(const Range& x, const Range& y) {
  if (x.is_empty() || y.is_empty()) return Range::empty();
  if (mpfr_sgn(x.lower()) >= 0) return multiply_nonnegative(x, y);
  if (mpfr_sgn(y.lower()) >= 0) return multiply_nonnegative(y, x);
  if (mpfr_sgn(x.upper()) <= 0) return -multiply_nonnegative(-x, y);
  if (mpfr_sgn(y.upper()) <= 0) return -multiply_nonnegative(-y, x);
  return multiply_straddling(x, y);
}

Range operator/(const Range& x, const Range& y) {
  if (x.is_empty() || y.is_empty() || y.is_zero()) return Range::empty();
  if (x.is_zero()) return x;
  if (mpfr_sgn(y.lower()) >= 0) return divide_by_nonnegative(x, y);
  if (mpfr_sgn(y.upper()) <= 0) return -divide_by_nonnegative(x, -y);
  return Range::entire();
}

Range scaled(double factor, const Range& x) {
  if (x.is_empty()) return x;
  if (factor == 0) return 0.0;
  if (factor < 0) return -scaled(-factor, x);
  Range result;
  mpfr_mul_d(result.lower(), x.lower(), factor, MPFR_RNDD);
  mpfr_mul_d(result.upper(), x.upper(), factor, MPFR_RNDU);
  return result;
}

Range sqr(const Range& x) { return increasing(mpfr_sqr, abs(x)); }

Range power(const Range& x, const Rational& exponent) {
  if (x.is_empty()) return x;
  if (exponent == 0) return 1.0;
  const bool even_root = mpz_even_p(exponent.get_den_mpz_t()) != 0;
  const bool even_power = mpz_even_p(exponent.get_num_mpz_t()) != 0;
  Range right = power_of_nonnegative(nonnegative_part(x), exponent);
  if (even_root || mpfr_sgn(x.lower()) >= 0) return right;
  const Range left = power_of_nonnegative(nonnegative_part(-x), exponent);
  return hull(right, even_power ? left : -left);
}

Range sqrt(const Range& x) { return increasing(mpfr_sqrt, nonnegative_part(x)); }
Range cbrt(const Range& x) { return increasing(mpfr_cbrt, x); }
Range exp(const Range& x) { return increasing(mpfr_exp, x); }

Range log(const Range& x) {
  const Range domain = nonnegative_part(x);
  if (domain.is_empty() || mpfr_zero_p(domain.upper()) != 0) return Range::empty();
  return increasing(mpfr_log, domain);
}

Range sin(const Range& x) { return periodic(mpfr_sin, 1, 3, x); }
Range cos(const Range& x) { return periodic(mpfr_cos, 0, 2, x); }

Range tan(const Range& x) {
  if (x.is_empty()) return x;
  const QuarterTurns turns(x);
  if (!x.is_bounded() || turns.meets(1) || turns.meets(3)) return Range::entire();
  return increasing(mpfr_tan, x);
}

Range asin(const Range& x) { return increasing(mpfr_asin, intersection(x, Range(Interval(-1, 1)))); }

Range acos(const Range& x) {
  Range domain = intersection(x, Range(Interval(-1, 1)));
  if (domain.is_empty()) return domain;
  Range result;
  mpfr_acos(result.lower(), domain.upper(), MPFR_RNDD);
  mpfr_acos(result.upper(), domain.lower(), MPFR_RNDU);
  return result;
}

Range atan(const Range& x) { return increasing(mpfr_atan, x); }

Range abs(const Range& x) {
  if (x.is_empty() || mpfr_sgn(x.lower()) >= 0) return x;
  if (mpfr_sgn(x.upper()) <= 0) return -x;
  Range result = hull(x, -x);
  mpfr_set_zero(result.lower(), 1);
  return result;
}

Range min(const Range& x, const Range& y) {
  if (x.is_empty() || y.is_empty()) return Range::empty();
  Range result;
  mpfr_min(result.lower(), x.lower(), y.lower(), MPFR_RNDD);
  mpfr_min(result.upper(), x.upper(), y.upper(), MPFR_RNDU);
  return result;
}

Range max(const Range& x, const Range& y) {
  if (x.is_empty() || y.is_empty()) return Range::empty();
  return -min(-x, -y);
}

Range intersection(const Range& x, const Range& y) {
  if (x.is_empty() || y.is_empty()) return Range::empty();
  Range result;
  mpfr_max(result.lower(), x.lower(), y.lower(), MPFR_RNDD);
  mpfr_min(result.upper(), x.upper(), y.upper(), MPFR_RNDU);
  return result.is_empty() ? Range::empty() : result;
}

Range hull(const Range& x, const Range& y) {
  if (x.is_empty()) return y;
  if (y.is_empty()) return x;
  Range result;
  mpfr_min(result.lower(), x.lower(), y.lower(), MPFR_RNDD);
  mpfr_max(result.upper(), x.upper(), y.upper(), MPFR_RNDU);
  return result;
}

Real middle(const Range& x) {
  Real result;
  if (!x.is_bounded()) return result;
  mpfr_add(result.get(), x.lower(), x.upper(), MPFR_RNDN);
  mpfr_div_2ui(result.get(), result.get(), 1, MPFR_RNDN);
  return result;
}

Real magnitude(const Range& x) {
  Real result;
  mpfr_max(result.get(), abs(x).upper(), result.get(), MPFR_RNDU);
  return result;
}

}  // namespace gcslab::verifier
