#pragma once

// What an expression needs to know of a number type T to be evaluated over it.
//
// Besides the traits, T has, found by argument-dependent lookup in namespace gcslab:
//   + - * / (binary), unary -, sqr, pow(T, int), pow(T, const Rational&), sqrt, cbrt, exp, log, sin, cos,
//   tan, asin, acos, atan, abs, min, max,
// and for derivatives
//   sign_enclosure(x)     encloses the generalised derivative of |x|: -1, 1 or, around 0, [-1, 1],
//   less_enclosure(x, y)  encloses the indicator of x < y: 0, 1 or [0, 1].
// Set-valued types follow IEEE 1788: an operation encloses {op(a, b) : a in x, b in y, op defined at (a, b)},
// so an operand outside the natural domain gives the empty set, and one partly outside is cut down to the
// domain first. The point types double and float are fundamental, and Rational is gmpxx's: argument-dependent
// lookup does not reach them, so templates over number types include interval/point_numbers.h first.

#include "base/outcome.h"
#include "interval/interval.h"
#include "interval/rational.h"

namespace gcslab {

/// Primary template; each number type specialises it beside its own definition.
///
///   struct Scope { explicit Scope(int bits = 53); };  alive while operations on T run: it sets the rounding
///   mode
///                                                      (fast), the precision (MPFR) or fresh noise symbols
///                                                      (affine)
///   static T from_rational(const Rational&);           encloses the number (point types: nearest)
///   static T from_interval(const Interval&);           encloses the set (set-valued types only)
///   static T pi();
///   static Interval enclosure(const T&);               a double interval that contains the value
///   static constexpr Promise promise;                  baseline for point and unrounded types
///   static constexpr bool is_set;                      true when from_interval exists
template <class T>
struct NumberTraits;

/// A number type whose values are sets of reals.
template <class T>
concept SetNumber = NumberTraits<T>::is_set;

/// The derivative of |x|: -1 or 1 where the sign is known, else [-1, 1].
template <SetNumber T>
T sign_enclosure(const T& x) {
  const Interval range = NumberTraits<T>::enclosure(x);
  if (is_empty(range)) return NumberTraits<T>::from_interval(Interval::empty());
  if (range.lower > 0) return NumberTraits<T>::from_interval(1);
  if (range.upper < 0) return NumberTraits<T>::from_interval(-1);
  return NumberTraits<T>::from_interval({-1, 1});
}

/// The truth of x < y as a number: 1 or 0 where it is known, else [0, 1].
template <SetNumber T>
T less_enclosure(const T& x, const T& y) {
  const Interval left = NumberTraits<T>::enclosure(x);
  const Interval right = NumberTraits<T>::enclosure(y);
  if (is_empty(left) || is_empty(right)) return NumberTraits<T>::from_interval(Interval::empty());
  if (left.upper < right.lower) return NumberTraits<T>::from_interval(1);
  if (right.upper <= left.lower) return NumberTraits<T>::from_interval(0);
  return NumberTraits<T>::from_interval({0, 1});
}

}  // namespace gcslab
