#pragma once

// The point types as numbers: double and float (baselines: every operation rounds to nearest, elementary
// functions are libm's) and Rational (exact: + - * / sqr pow abs min max; the other functions throw
// NotApplicable, as does a division by zero in pow). An operation of double or float outside its domain gives
// NaN; gmpxx's division by a Rational zero ends the process, so divide(x, y), which throws NotApplicable
// instead, is there for callers that cannot rule it out.

#include <cmath>
#include <concepts>
#include <limits>
#include <numbers>

#include "interval/number_traits.h"
#include "interval/rounding.h"

namespace gcslab {

template <std::floating_point T>
T sqr(T x) {
  return x * x;
}
template <std::floating_point T>
T sqrt(T x) {
  return std::sqrt(x);
}
template <std::floating_point T>
T cbrt(T x) {
  return std::cbrt(x);
}
template <std::floating_point T>
T exp(T x) {
  return std::exp(x);
}
template <std::floating_point T>
T log(T x) {
  return std::log(x);
}
template <std::floating_point T>
T sin(T x) {
  return std::sin(x);
}
template <std::floating_point T>
T cos(T x) {
  return std::cos(x);
}
template <std::floating_point T>
T tan(T x) {
  return std::tan(x);
}
template <std::floating_point T>
T asin(T x) {
  return std::asin(x);
}
template <std::floating_point T>
T acos(T x) {
  return std::acos(x);
}
template <std::floating_point T>
T atan(T x) {
  return std::atan(x);
}
template <std::floating_point T>
T abs(T x) {
  return std::fabs(x);
}
template <std::floating_point T>
T min(T x, T y) {
  return y < x ? y : x;
}
template <std::floating_point T>
T max(T x, T y) {
  return x < y ? y : x;
}
template <std::floating_point T>
T sign_enclosure(T x) {
  return static_cast<T>((x > 0) - (x < 0));
}
template <std::floating_point T>
T less_enclosure(T x, T y) {
  return x < y ? T(1) : T(0);
}

/// x^n by repeated squaring, so that the result does not depend on libm.
template <std::floating_point T>
T pow(T x, int n) {
  const bool inverse = n < 0;
  unsigned rest = inverse ? 0U - static_cast<unsigned>(n) : static_cast<unsigned>(n);
  T power = 1;
  for (T base = x; rest != 0; rest >>= 1U, base *= base) {
    if (rest & 1U) power *= base;
  }
  return inverse ? 1 / power : power;
}

double pow(double x, const Rational& exponent);
float pow(float x, const Rational& exponent);

Rational sqr(const Rational& x);
Rational pow(const Rational& x, int n);
Rational pow(const Rational& x, const Rational& exponent);  ///< integer exponents only
Rational abs(const Rational& x);
Rational min(const Rational& x, const Rational& y);
Rational max(const Rational& x, const Rational& y);
Rational divide(const Rational& x, const Rational& y);
Rational sign_enclosure(const Rational& x);
Rational less_enclosure(const Rational& x, const Rational& y);
[[noreturn]] Rational sqrt(const Rational& x);
[[noreturn]] Rational cbrt(const Rational& x);
[[noreturn]] Rational exp(const Rational& x);
[[noreturn]] Rational log(const Rational& x);
[[noreturn]] Rational sin(const Rational& x);
[[noreturn]] Rational cos(const Rational& x);
[[noreturn]] Rational tan(const Rational& x);
[[noreturn]] Rational asin(const Rational& x);
[[noreturn]] Rational acos(const Rational& x);
[[noreturn]] Rational atan(const Rational& x);

template <>
struct NumberTraits<double> {
  struct Scope {
    explicit Scope(int /*bits*/ = 53) {}
    NearestRounding nearest;
  };
  static double from_rational(const Rational& value) { return nearest_double(value); }
  static double pi() { return std::numbers::pi; }
  static Interval enclosure(double x);
  static constexpr Promise promise = Promise::baseline;
  static constexpr bool is_set = false;
};

template <>
struct NumberTraits<float> {
  using Scope = NumberTraits<double>::Scope;
  static float from_rational(const Rational& value);
  static float pi() { return std::numbers::pi_v<float>; }
  static Interval enclosure(float x) { return NumberTraits<double>::enclosure(static_cast<double>(x)); }
  static constexpr Promise promise = Promise::baseline;
  static constexpr bool is_set = false;
};

template <>
struct NumberTraits<Rational> {
  struct Scope {
    explicit Scope(int /*bits*/ = 53) {}
    ~Scope() {}  // NOLINT: so that a scope nobody names again raises no warning
  };
  static Rational from_rational(const Rational& value) { return value; }
  [[noreturn]] static Rational pi();
  static Interval enclosure(const Rational& x);
  static constexpr Promise promise = Promise::rigorous;
  static constexpr bool is_set = false;
};

}  // namespace gcslab
