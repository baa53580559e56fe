#pragma once

// Numbers that carry N first derivatives (dual numbers), in doubles: an operation on jets is one on values
// and the chain rule on derivatives (forward mode: Griewank, Walther 2008, section 3.1). Where an operation
// has no derivative, that of jets is not finite.

#include <array>
#include <cmath>
#include <cstddef>

#include "interval/point_numbers.h"

namespace gcslab {

template <std::size_t N>
struct Jet {
  double value = 0;
  std::array<double, N> slopes{};
};

/// The value without its derivatives; of a double itself.
inline double point_value(double x) { return x; }
template <std::size_t N>
double point_value(const Jet<N>& x) {
  return x.value;
}

/// f(x) where f has that value and that derivative at x.
template <std::size_t N>
Jet<N> chain(const Jet<N>& x, double value, double slope) {
  Jet<N> result{value, {}};
  for (std::size_t i = 0; i < N; ++i) result.slopes[i] = slope * x.slopes[i];
  return result;
}

/// f(x, y), likewise.
template <std::size_t N>
Jet<N> chain(const Jet<N>& x, const Jet<N>& y, double value, double slope_x, double slope_y) {
  Jet<N> result{value, {}};
  for (std::size_t i = 0; i < N; ++i) result.slopes[i] = slope_x * x.slopes[i] + slope_y * y.slopes[i];
  return result;
}

template <std::size_t N>
Jet<N> operator+(const Jet<N>& x, const Jet<N>& y) {
  return chain(x, y, x.value + y.value, 1, 1);
}
template <std::size_t N>
Jet<N> operator-(const Jet<N>& x, const Jet<N>& y) {
  return chain(x, y, x.value - y.value, 1, -1);
}
template <std::size_t N>
Jet<N> operator*(const Jet<N>& x, const Jet<N>& y) {
  return chain(x, y, x.value * y.value, y.value, x.value);
}
template <std::size_t N>
Jet<N> operator/(const Jet<N>& x, const Jet<N>& y) {
  const double quotient = x.value / y.value;
  return chain(x, y, quotient, 1 / y.value, -quotient / y.value);
}
template <std::size_t N>
Jet<N> operator-(const Jet<N>& x) {
  return chain(x, -x.value, -1);
}
template <std::size_t N>
Jet<N> sqr(const Jet<N>& x) {
  return chain(x, x.value * x.value, 2 * x.value);
}
template <std::size_t N>
Jet<N> pow(const Jet<N>& x, int n) {
  return chain(x, pow(x.value, n), n == 0 ? 0 : n * pow(x.value, n - 1));
}
template <std::size_t N>
Jet<N> pow(const Jet<N>& x, const Rational& exponent) {
  return chain(x, pow(x.value, exponent), nearest_double(exponent) * pow(x.value, Rational(exponent - 1)));
}
template <std::size_t N>
Jet<N> sqrt(const Jet<N>& x) {
  const double root = std::sqrt(x.value);
  return chain(x, root, 0.5 / root);
}
template <std::size_t N>
Jet<N> cbrt(const Jet<N>& x) {
  const double root = std::cbrt(x.value);
  return chain(x, root, 1 / (3 * root * root));
}
template <std::size_t N>
Jet<N> exp(const Jet<N>& x) {
  const double value = std::exp(x.value);
  return chain(x, value, value);
}
template <std::size_t N>
Jet<N> log(const Jet<N>& x) {
  return chain(x, std::log(x.value), 1 / x.value);
}
template <std::size_t N>
Jet<N> sin(const Jet<N>& x) {
  return chain(x, std::sin(x.value), std::cos(x.value));
}
template <std::size_t N>
Jet<N> cos(const Jet<N>& x) {
  return chain(x, std::cos(x.value), -std::sin(x.value));
}
template <std::size_t N>
Jet<N> tan(const Jet<N>& x) {
  const double value = std::tan(x.value);
  return chain(x, value, 1 + value * value);
}
template <std::size_t N>
Jet<N> asin(const Jet<N>& x) {
  return chain(x, std::asin(x.value), 1 / std::sqrt(1 - x.value * x.value));
}
template <std::size_t N>
Jet<N> acos(const Jet<N>& x) {
  return chain(x, std::acos(x.value), -1 / std::sqrt(1 - x.value * x.value));
}
template <std::size_t N>
Jet<N> atan(const Jet<N>& x) {
  return chain(x, std::atan(x.value), 1 / (1 + x.value * x.value));
}
template <std::size_t N>
Jet<N> abs(const Jet<N>& x) {
  return chain(x, std::abs(x.value), sign_enclosure(x.value));
}
template <std::size_t N>
Jet<N> min(const Jet<N>& x, const Jet<N>& y) {
  return y.value < x.value ? y : x;
}
template <std::size_t N>
Jet<N> max(const Jet<N>& x, const Jet<N>& y) {
  return x.value < y.value ? y : x;
}

template <std::size_t N>
struct NumberTraits<Jet<N>> {
  using Scope = NumberTraits<double>::Scope;
  static Jet<N> from_rational(const Rational& value) {
    return {NumberTraits<double>::from_rational(value), {}};
  }
  static Jet<N> pi() { return {NumberTraits<double>::pi(), {}}; }
  static Interval enclosure(const Jet<N>& x) { return NumberTraits<double>::enclosure(x.value); }
  static constexpr Promise promise = Promise::baseline;
  static constexpr bool is_set = false;
};

}  // namespace gcslab
