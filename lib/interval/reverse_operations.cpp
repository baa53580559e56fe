#include "interval/reverse_operations.h"

#include <cmath>

namespace gcslab {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// For types whose ends are doubles.
template <class T>
T from_doubles(const Interval& x) {
  return NumberTraits<T>::from_interval(x);
}
template <class T>
Interval doubles(const T& x) {
  return NumberTraits<T>::enclosure(x);
}

MpfrInterval from_ends(mpfr_srcptr lower, mpfr_srcptr upper) {
  return MpfrInterval(MpfrNumber(lower), MpfrNumber(upper));
}

}  // namespace

BoostInterval intersection(const BoostInterval& x, const BoostInterval& y) {
  return from_doubles<BoostInterval>(intersection(doubles(x), doubles(y)));
}
UnroundedInterval intersection(const UnroundedInterval& x, const UnroundedInterval& y) {
  return from_doubles<UnroundedInterval>(intersection(doubles(x), doubles(y)));
}
MpfrInterval intersection(const MpfrInterval& x, const MpfrInterval& y) {
  if (x.is_empty() || y.is_empty()) return MpfrInterval();
  const mpfr_srcptr lower = mpfr_less_p(x.lower(), y.lower()) != 0 ? y.lower() : x.lower();
  const mpfr_srcptr upper = mpfr_less_p(x.upper(), y.upper()) != 0 ? x.upper() : y.upper();
  if (mpfr_lessequal_p(lower, upper) == 0) return MpfrInterval();
  return from_ends(lower, upper);
}

BoostInterval hull(const BoostInterval& x, const BoostInterval& y) {
  return from_doubles<BoostInterval>(hull(doubles(x), doubles(y)));
}
UnroundedInterval hull(const UnroundedInterval& x, const UnroundedInterval& y) {
  return from_doubles<UnroundedInterval>(hull(doubles(x), doubles(y)));
}
MpfrInterval hull(const MpfrInterval& x, const MpfrInterval& y) {
  if (x.is_empty()) return y;
  if (y.is_empty()) return x;
  const mpfr_srcptr lower = mpfr_less_p(x.lower(), y.lower()) != 0 ? x.lower() : y.lower();
  const mpfr_srcptr upper = mpfr_less_p(x.upper(), y.upper()) != 0 ? y.upper() : x.upper();
  return from_ends(lower, upper);
}

namespace {

template <class T>
T interval(double lower, double upper) {
  return NumberTraits<T>::from_interval(Interval(lower, upper));
}

template <class T>
bool contains_zero(const T& x) {
  return contains(NumberTraits<T>::enclosure(x), 0);
}

template <class T>
T nonnegative(const T& x) {
  return intersection(x, interval<T>(0, kInfinity));
}

/// The parts of two pieces that lie within a set.
template <class T>
T pieces_within(const T& first, const T& second, const T& within) {
  return hull(intersection(first, within), intersection(second, within));
}

/// {k period + offset : offset in z} for the integers k that can matter, within `within`; `within` itself
/// when those are many. `period` and `offset` enclose.
template <class T>
T repeated_within(const T& z, const T& period, const T& within) {
  constexpr double kMaximumCopies = 8;
  const Interval copies = NumberTraits<T>::enclosure((within - z) / period);
  T result = NumberTraits<T>::from_interval(Interval::empty());
  if (is_empty(copies)) return result;
  if (!is_bounded(copies) || width(copies) > kMaximumCopies || magnitude(copies) > 1e15) return within;
  const double first = std::ceil(copies.lower);
  for (int i = 0; first + i <= copies.upper; ++i) {
    const T shift = NumberTraits<T>::from_interval(Interval(first + i)) * period;
    result = hull(result, intersection(z + shift, within));
  }
  return result;
}

}  // namespace

template <SetNumber T>
T reverse_multiply(const T& product, const T& factor, const T& within) {
  if (!contains_zero(factor)) return intersection(product / factor, within);
  if (contains_zero(product)) return within;
  const T negative = intersection(factor, interval<T>(-kInfinity, 0));
  const T positive = intersection(factor, interval<T>(0, kInfinity));
  return pieces_within(product / negative, product / positive, within);
}

template <SetNumber T>
T reverse_dividend(const T& quotient, const T& divisor, const T& within) {
  return intersection(quotient * divisor, within);
}

template <SetNumber T>
T reverse_divisor(const T& quotient, const T& dividend, const T& within) {
  return reverse_multiply(dividend, quotient, within);
}

template <SetNumber T>
T reverse_sqr(const T& z, const T& within) {
  const T root = sqrt(z);
  return pieces_within(root, -root, within);
}

/// A number at or below the n-th root of x > 0, and near it; 0 when the quick way fails. The power decides,
/// so that nothing rests on the library's root.
double root_below(double x, int n) {
  const double guess = std::pow(x, 1.0 / n) * (1 - 4e-16);
  return guess > 0 && pow(FastInterval(guess), n).upper() <= x ? guess : 0;
}

/// A number at or above it; infinite when the quick way fails.
double root_above(double x, int n) {
  const double guess = std::pow(x, 1.0 / n) * (1 + 4e-16);
  return guess < kInfinity && pow(FastInterval(guess), n).lower() >= x ? guess : kInfinity;
}

/// The n-th roots of the positive members of z, n > 0.
FastInterval positive_root(FastInterval z, int n) {
  const double lower = z.lower() > 0 ? root_below(z.lower(), n) : 0;
  const double upper = z.upper() > 0 ? root_above(z.upper(), n) : 0;
  return {lower, upper};
}

/// {x : x^n in z} for an integer n > 0, quickly and a few units wider than need be.
FastInterval quick_root(FastInterval z, int n, FastInterval within) {
  if (z.is_empty()) return z;
  const FastInterval up = z.upper() >= 0 ? positive_root(z, n) : FastInterval();
  if (n % 2 == 0) return pieces_within(up, -up, within);
  const FastInterval down = z.lower() < 0 ? -positive_root(-z, n) : FastInterval();
  return intersection(hull(up, down), within);
}

template <SetNumber T>
T reverse_power(const T& z, const Rational& exponent, const T& within) {
  if (exponent == 0) return within;
  if constexpr (std::is_same_v<T, FastInterval>) {
    if (exponent > 0 && exponent <= 64 && exponent.get_den() == 1)  // NOLINT: the macros of GMP compare twice
      return quick_root(z, static_cast<int>(exponent.get_num().get_si()), within);
  }
  const Rational inverse = 1 / exponent;
  const bool even = mpz_even_p(exponent.get_num_mpz_t()) != 0;
  const bool even_root = mpz_even_p(exponent.get_den_mpz_t()) != 0;
  if (even) {
    const T root = pow(nonnegative(z), inverse);
    return pieces_within(root, -root, within);
  }
  if (even_root) return intersection(pow(nonnegative(z), inverse), within);
  return intersection(pow(z, inverse), within);
}

template <SetNumber T>
T reverse_abs(const T& z, const T& within) {
  const T size = nonnegative(z);
  return pieces_within(size, -size, within);
}

template <SetNumber T>
T reverse_sqrt(const T& z, const T& within) {
  return intersection(sqr(nonnegative(z)), within);
}

template <SetNumber T>
T reverse_cbrt(const T& z, const T& within) {
  return intersection(pow(z, 3), within);
}

template <SetNumber T>
T reverse_exp(const T& z, const T& within) {
  return intersection(log(z), within);
}

template <SetNumber T>
T reverse_log(const T& z, const T& within) {
  return intersection(exp(z), within);
}

/// Encloses asin, quickly and a few units wider than need be: the sine of a guess decides on which side of
/// the arc sine it lies.
FastInterval arc_sine(FastInterval z) {
  const FastInterval inside = intersection(z, FastInterval(-1, 1));
  if (inside.is_empty()) return inside;
  constexpr double kPart = 4e-16;
  constexpr double kQuarter = 1.57;  // guesses stay where the sine increases
  const double size = std::fabs(std::asin(inside.lower())) + std::fabs(std::asin(inside.upper()));
  const double lower = std::asin(inside.lower()) - kPart * size;
  const double upper = std::asin(inside.upper()) + kPart * size;
  const bool is_safe = lower >= -kQuarter && upper <= kQuarter &&
                       sin(FastInterval(lower)).upper() <= inside.lower() &&
                       sin(FastInterval(upper)).lower() >= inside.upper();
  return is_safe ? FastInterval(lower, upper) : asin(inside);
}

/// The same for acos.
FastInterval arc_cosine(FastInterval z) {
  const FastInterval inside = intersection(z, FastInterval(-1, 1));
  if (inside.is_empty()) return inside;
  constexpr double kPart = 1e-15;
  const double lower = std::acos(inside.upper()) * (1 - kPart);
  const double upper = std::acos(inside.lower()) * (1 + kPart);
  const bool is_safe = lower >= 0 && upper <= 3.14 && cos(FastInterval(lower)).lower() >= inside.upper() &&
                       cos(FastInterval(upper)).upper() <= inside.lower();
  return is_safe ? FastInterval(lower, upper) : acos(inside);
}

template <class T>
T arc_sine(const T& z) {
  return asin(z);
}
template <class T>
T arc_cosine(const T& z) {
  return acos(z);
}

template <SetNumber T>
T reverse_sin(const T& z, const T& within) {
  const T angle = arc_sine(z);
  const T pi = NumberTraits<T>::pi();
  const T period = pi + pi;
  return hull(repeated_within<T>(angle, period, within), repeated_within<T>(pi - angle, period, within));
}

template <SetNumber T>
T reverse_cos(const T& z, const T& within) {
  const T angle = arc_cosine(z);
  const T pi = NumberTraits<T>::pi();
  const T period = pi + pi;
  return hull(repeated_within<T>(angle, period, within), repeated_within<T>(-angle, period, within));
}

template <SetNumber T>
T reverse_tan(const T& z, const T& within) {
  return repeated_within<T>(atan(z), NumberTraits<T>::pi(), within);
}

template <SetNumber T>
T reverse_asin(const T& z, const T& within) {
  const T half_turn = NumberTraits<T>::pi();
  const T quarter = half_turn * NumberTraits<T>::from_rational(Rational(1, 2));
  return intersection(sin(intersection(z, hull(-quarter, quarter))), within);
}

template <SetNumber T>
T reverse_acos(const T& z, const T& within) {
  const T zero = NumberTraits<T>::from_rational(0);
  return intersection(cos(intersection(z, hull(zero, NumberTraits<T>::pi()))), within);
}

template <SetNumber T>
T reverse_atan(const T& z, const T& within) {
  const T quarter = NumberTraits<T>::pi() * NumberTraits<T>::from_rational(Rational(1, 2));
  // An end of z at a quarter turn stands for every argument beyond: tan of its enclosure has a pole there.
  T inside = intersection(z, hull(-quarter, quarter));
  const Interval ends = NumberTraits<T>::enclosure(inside);
  if (is_empty(ends)) return inside;
  const Interval border = NumberTraits<T>::enclosure(quarter);
  if (ends.upper >= border.lower || ends.lower <= -border.lower) return within;
  return intersection(tan(inside), within);
}

template <SetNumber T>
T reverse_min(const T& z, const T& other, const T& within) {
  const Interval ends = NumberTraits<T>::enclosure(z);
  if (is_empty(ends)) return z;
  // When the other operand cannot be the smaller one, this one is.
  if (ends.upper < NumberTraits<T>::enclosure(other).lower) return intersection(within, z);
  return intersection(within, hull(z, interval<T>(midpoint(ends), kInfinity)));
}

template <SetNumber T>
T reverse_max(const T& z, const T& other, const T& within) {
  return -reverse_min<T>(-z, -other, -within);
}

#define GCSLAB_REVERSE_OPERATIONS(T)                                \
  template T reverse_multiply<T>(const T&, const T&, const T&);     \
  template T reverse_dividend<T>(const T&, const T&, const T&);     \
  template T reverse_divisor<T>(const T&, const T&, const T&);      \
  template T reverse_sqr<T>(const T&, const T&);                    \
  template T reverse_power<T>(const T&, const Rational&, const T&); \
  template T reverse_abs<T>(const T&, const T&);                    \
  template T reverse_sqrt<T>(const T&, const T&);                   \
  template T reverse_cbrt<T>(const T&, const T&);                   \
  template T reverse_exp<T>(const T&, const T&);                    \
  template T reverse_log<T>(const T&, const T&);                    \
  template T reverse_sin<T>(const T&, const T&);                    \
  template T reverse_cos<T>(const T&, const T&);                    \
  template T reverse_tan<T>(const T&, const T&);                    \
  template T reverse_asin<T>(const T&, const T&);                   \
  template T reverse_acos<T>(const T&, const T&);                   \
  template T reverse_atan<T>(const T&, const T&);                   \
  template T reverse_min<T>(const T&, const T&, const T&);          \
  template T reverse_max<T>(const T&, const T&, const T&);

GCSLAB_REVERSE_OPERATIONS(FastInterval)
GCSLAB_REVERSE_OPERATIONS(BoostInterval)
GCSLAB_REVERSE_OPERATIONS(MpfrInterval)
GCSLAB_REVERSE_OPERATIONS(UnroundedInterval)
#undef GCSLAB_REVERSE_OPERATIONS

}  // namespace gcslab
