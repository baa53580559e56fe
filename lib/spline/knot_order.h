#pragma once

// The order of knots and parameters, over any number type.
//
// Double and Rational have an order; jets are ordered by their values. Of sets (intervals) one is before
// another when each of its members is; two that overlap have no order. Where knots are sets, equal enclosures
// stand for one number, and a NumberTraits<T>::Scope must be alive.

#include <array>
#include <charconv>
#include <concepts>
#include <string>

#include "interval/jet.h"
#include "interval/number_traits.h"
#include "interval/point_numbers.h"

namespace gcslab {

/// a < b for all members.
template <class T>
bool surely_less(const T& a, const T& b) {
  if constexpr (SetNumber<T>) {
    return NumberTraits<T>::enclosure(b - a).lower > 0;
  } else if constexpr (requires { a < b; }) {
    return a < b;
  } else {
    return point_value(a) < point_value(b);
  }
}

/// a <= b for all members.
template <class T>
bool surely_at_most(const T& a, const T& b) {
  if constexpr (SetNumber<T>) {
    return NumberTraits<T>::enclosure(b - a).lower >= 0;
  } else if constexpr (requires { a <= b; }) {
    return a <= b;
  } else {
    return point_value(a) <= point_value(b);
  }
}

/// The same knot: equal numbers, or equal enclosures of one.
template <class T>
bool same_knot(const T& a, const T& b) {
  if constexpr (SetNumber<T>) {
    return NumberTraits<T>::enclosure(a) == NumberTraits<T>::enclosure(b) && !surely_less(a, b) &&
           !surely_less(b, a);
  } else if constexpr (requires { a == b; }) {
    return a == b;
  } else {
    return point_value(a) == point_value(b);
  }
}

/// Neither NaN, infinite, empty nor unbounded.
template <class T>
bool is_finite_number(const T& x) {
  if constexpr (std::floating_point<T>) {
    return std::isfinite(x);
  } else if constexpr (std::same_as<T, Rational>) {
    return true;
  } else if constexpr (SetNumber<T>) {
    return is_bounded(NumberTraits<T>::enclosure(x));
  } else {
    return std::isfinite(point_value(x));
  }
}

/// The integer as a number of the type.
template <class T>
T whole_number(long value) {
  if constexpr (std::floating_point<T>) {
    return static_cast<T>(value);
  } else {
    return NumberTraits<T>::from_rational(Rational(value));
  }
}

/// For messages: shortest digits, a fraction, or an enclosure.
template <class T>
std::string number_text(const T& x) {
  if constexpr (std::floating_point<T>) {
    std::array<char, 64> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), x).ptr;
    return {digits.data(), end};
  } else if constexpr (std::same_as<T, Rational>) {
    return x.get_str();
  } else if constexpr (SetNumber<T>) {
    return to_string(NumberTraits<T>::enclosure(x));
  } else {
    return number_text(point_value(x));
  }
}

/// The part of x between the two: x itself, or the nearer end.
template <class T>
T cut_to(const T& x, const T& lower, const T& upper) {
  return min(T(max(x, lower)), upper);
}

/// A set that contains both.
template <SetNumber T>
T joint_enclosure(const T& a, const T& b) {
  return NumberTraits<T>::from_interval(hull(NumberTraits<T>::enclosure(a), NumberTraits<T>::enclosure(b)));
}

/// The number in another type: exact into Rational, else nearest or enclosing. The source is double or
/// Rational.
template <class To, class From>
To converted_number(const From& x) {
  if constexpr (std::same_as<To, From>) {
    return x;
  } else if constexpr (std::same_as<From, Rational>) {
    return NumberTraits<To>::from_rational(x);
  } else {
    return NumberTraits<To>::from_rational(rational_from_double(x));
  }
}

}  // namespace gcslab
