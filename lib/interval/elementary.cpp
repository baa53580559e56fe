#include "interval/elementary.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mpfr.h>
#include <optional>

#include "interval/accurate_functions.h"
#include "interval/quadrant.h"
#include "interval/rounding.h"

namespace gcslab::elementary {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Bits of intermediate roots: 53 of the result, 31 that a power may cost, and 76 to spare.
constexpr mpfr_prec_t kRootPrecision = 160;

/// One thread's MPFR variables, so that no evaluation allocates.
struct Workspace {
  Workspace() {
    mpfr_inits2(53, argument, value, static_cast<mpfr_ptr>(nullptr));
    mpfr_inits2(kRootPrecision, root, exponent, static_cast<mpfr_ptr>(nullptr));
  }
  ~Workspace() {
    mpfr_clears(argument, value, root, exponent, static_cast<mpfr_ptr>(nullptr));
    mpfr_free_cache();
  }
  Workspace(const Workspace&) = delete;
  Workspace& operator=(const Workspace&) = delete;

  mpfr_t argument, value, root, exponent;
};

Workspace& workspace() {
  thread_local Workspace variables;
  return variables;
}

mpfr_rnd_t first_rounding(Ends ends) { return ends == Ends::outward ? MPFR_RNDD : MPFR_RNDN; }

mpfr_rnd_t opposite(mpfr_rnd_t rounding) {
  if (rounding == MPFR_RNDN) return MPFR_RNDN;
  return rounding == MPFR_RNDD ? MPFR_RNDU : MPFR_RNDD;
}

/// The doubles around the number of which `value` is the rounding by first_rounding, inexact where ternary !=
/// 0.
Interval around(mpfr_ptr value, int ternary, Ends ends) {
  if (ends == Ends::to_nearest) return mpfr_get_d(value, MPFR_RNDN);
  const double lower = mpfr_get_d(value, MPFR_RNDD);
  if (ternary != 0) mpfr_nextabove(value);
  const double upper = mpfr_get_d(value, MPFR_RNDU);
  return {lower + 0.0, upper + 0.0};  // no -0
}

/// The doubles around a number known to lie in [v - e, v + e]; none if that does not settle both roundings.
/// Each pair of sums bounds the rounded end from both sides: where they agree, they are it.
std::optional<Interval> settled_outward(const AccurateValue& v) {
  const double upper = rounded_add(v.high, rounded_add(v.low, v.error));
  if (upper != rounded_add(v.high, -rounded_subtract(v.error, v.low))) return std::nullopt;
  const double minus_lower = rounded_add(-v.high, rounded_subtract(v.error, v.low));
  if (minus_lower != rounded_add(-v.high, -rounded_add(v.low, v.error))) return std::nullopt;
  return Interval(0.0 - minus_lower, upper);
}

/// The error counts twice, as the inner sums are rounded: by 2^-53 |low|, which is less than the error, since
/// |low| is below 2^-10 |high|, or beside a multiple of pi below 2^-52, where the error is 2^-100 or more.
std::optional<Interval> settled_to_nearest(const AccurateValue& v) {
  const double nearest = rounded_add(v.high, rounded_add(v.low, 2 * v.error));
  if (nearest != rounded_add(v.high, rounded_subtract(v.low, 2 * v.error))) return std::nullopt;
  return Interval(nearest);
}

/// The result without MPFR, in most cases.
std::optional<Interval> quickly(AccurateFunction f, double x, Ends ends) {
  if (ends == Ends::to_nearest) {
    const NearestRounding nearest;
    const AccurateValue value = f(opaque(x));
    return value.known ? settled_to_nearest(value) : std::nullopt;
  }
  const UpwardRounding upward;
  const AccurateValue value = f(opaque(x));
  return value.known ? settled_outward(value) : std::nullopt;
}

/// A function by MPFR, and by double arithmetic where there is such a way.
struct Function {
  int (*exact)(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t);
  AccurateFunction quick = nullptr;
};

constexpr Function kSqrt{mpfr_sqrt};
constexpr Function kCbrt{mpfr_cbrt};
constexpr Function kExp{mpfr_exp, accurate_exp};
constexpr Function kLog{mpfr_log, accurate_log};
constexpr Function kSin{mpfr_sin, accurate_sin};
constexpr Function kCos{mpfr_cos, accurate_cos};
constexpr Function kTan{mpfr_tan, accurate_tan};
constexpr Function kAsin{mpfr_asin};
constexpr Function kAcos{mpfr_acos};
constexpr Function kAtan{mpfr_atan, accurate_atan};

/// The doubles around f(x); an infinite x stands for the limit.
Interval at(const Function& f, double x, Ends ends) {
  if (f.quick != nullptr) {
    if (const auto result = quickly(f.quick, x, ends)) return *result;
  }
  Workspace& w = workspace();
  mpfr_set_d(w.argument, x, MPFR_RNDN);
  return around(w.value, f.exact(w.value, w.argument, first_rounding(ends)), ends);
}

Interval increasing(const Function& f, const Interval& x, Ends ends) {
  if (is_empty(x)) return x;
  const Interval low = at(f, x.lower, ends);
  const Interval high = is_singleton(x) ? low : at(f, x.upper, ends);
  return {low.lower, high.upper};
}

Interval decreasing(const Function& f, const Interval& x, Ends ends) {
  if (is_empty(x)) return x;
  const Interval high = at(f, x.lower, ends);
  const Interval low = is_singleton(x) ? high : at(f, x.upper, ends);
  return {low.lower, high.upper};
}

/// sin or cos, whose maxima and minima lie at the multiples k pi/2 with k = maximum or minimum modulo 4.
Interval periodic(const Function& f, int maximum, int minimum, const Interval& x, Ends ends) {
  if (is_empty(x)) return x;
  if (!is_bounded(x) || x.upper - x.lower > 6.5) return {-1, 1};
  const QuadrantSpan span = quadrant_span(x.lower, x.upper);
  const bool reaches_top = span.crosses(maximum);
  const bool reaches_bottom = span.crosses(minimum);
  if (reaches_top && reaches_bottom) return {-1, 1};
  const Interval low = at(f, x.lower, ends);
  const Interval high = is_singleton(x) ? low : at(f, x.upper, ends);
  return {reaches_bottom ? -1 : std::min(low.lower, high.lower),
          reaches_top ? 1 : std::max(low.upper, high.upper)};
}

/// t^(p/q), t > 0, by the q-th root rounded so that the power is rounded as asked. A rational t^(p/q) has a
/// rational root, so that exact results are found exact.
void power_by_root(mpfr_ptr power, mpfr_srcptr t, long p, unsigned long q, mpfr_rnd_t rounding) {
  mpfr_ptr root = workspace().root;
  mpfr_rootn_ui(root, t, q, p < 0 ? opposite(rounding) : rounding);
  mpfr_pow_si(power, root, p, rounding);
}

/// t^exponent for exponents of any size, by an enclosure of the exponent; t^e grows with e where t > 1.
void power_by_exponent(mpfr_ptr power, mpfr_srcptr t, const Rational& exponent, mpfr_rnd_t rounding) {
  mpfr_ptr rounded = workspace().exponent;
  mpfr_set_q(rounded, exponent.get_mpq_t(), mpfr_cmp_ui(t, 1) < 0 ? opposite(rounding) : rounding);
  mpfr_pow(power, t, rounded, rounding);
}

double power_rounded(double t, const Rational& exponent, mpfr_rnd_t rounding) {
  if (t == 0 || std::isinf(t)) return (t == 0) == (exponent > 0) ? 0 : kInfinity;
  if (t == 1) return 1;
  constexpr long kSmall = std::numeric_limits<int>::max();
  Workspace& w = workspace();
  mpfr_set_d(w.argument, t, MPFR_RNDN);
  if (abs(exponent.get_num()) <= kSmall && exponent.get_den() <= kSmall) {
    power_by_root(w.value, w.argument, exponent.get_num().get_si(), exponent.get_den().get_ui(), rounding);
  } else {
    power_by_exponent(w.value, w.argument, exponent, rounding);
  }
  return mpfr_get_d(w.value, rounding);
}

/// {t^exponent : t in x}, x without negative members, exponent not 0.
Interval nonnegative_power(const Interval& x, const Rational& exponent, Ends ends) {
  if (is_empty(x) || (exponent < 0 && x.upper == 0)) return Interval::empty();
  const bool grows = exponent > 0;
  const bool outward = ends == Ends::outward;
  return {power_rounded(grows ? x.lower : x.upper, exponent, outward ? MPFR_RNDD : MPFR_RNDN),
          power_rounded(grows ? x.upper : x.lower, exponent, outward ? MPFR_RNDU : MPFR_RNDN)};
}

Interval mirrored(const Interval& x) { return is_empty(x) ? x : Interval(0.0 - x.upper, 0.0 - x.lower); }

}  // namespace

Interval sqrt(const Interval& x, Ends ends) {
  return increasing(kSqrt, intersection(x, {0, kInfinity}), ends);
}

Interval cbrt(const Interval& x, Ends ends) { return increasing(kCbrt, x, ends); }
Interval exp(const Interval& x, Ends ends) { return increasing(kExp, x, ends); }

Interval log(const Interval& x, Ends ends) {
  if (!(x.upper > 0)) return Interval::empty();
  return increasing(kLog, {std::max(x.lower, 0.0), x.upper}, ends);
}

Interval sin(const Interval& x, Ends ends) { return periodic(kSin, 1, 3, x, ends); }
Interval cos(const Interval& x, Ends ends) { return periodic(kCos, 0, 2, x, ends); }

Interval tan(const Interval& x, Ends ends) {
  if (is_empty(x)) return x;
  if (!is_bounded(x) || x.upper - x.lower > 3.5) return Interval::entire();
  if (quadrant_span(x.lower, x.upper).crosses_odd()) return Interval::entire();
  return increasing(kTan, x, ends);
}

Interval asin(const Interval& x, Ends ends) { return increasing(kAsin, intersection(x, {-1, 1}), ends); }
Interval acos(const Interval& x, Ends ends) { return decreasing(kAcos, intersection(x, {-1, 1}), ends); }
Interval atan(const Interval& x, Ends ends) { return increasing(kAtan, x, ends); }

Interval pow(const Interval& x, const Rational& exponent, Ends ends) {
  if (is_empty(x)) return x;
  if (exponent == 0) return 1;
  const Interval right = nonnegative_power(intersection(x, {0, kInfinity}), exponent, ends);
  if (mpz_even_p(exponent.get_den_mpz_t())) return right;
  const Interval left = nonnegative_power(mirrored(intersection(x, {-kInfinity, 0})), exponent, ends);
  return hull(right, mpz_even_p(exponent.get_num_mpz_t()) ? left : mirrored(left));
}

Interval enclosing(const Rational& value, Ends ends) {
  mpfr_ptr rounded = workspace().value;
  return around(rounded, mpfr_set_q(rounded, value.get_mpq_t(), first_rounding(ends)), ends);
}

Interval pi(Ends ends) {
  mpfr_ptr rounded = workspace().value;
  return around(rounded, mpfr_const_pi(rounded, first_rounding(ends)), ends);
}

}  // namespace gcslab::elementary
