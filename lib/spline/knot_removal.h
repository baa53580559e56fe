#pragma once

// Removal of knots: the same curve, or one near it, over a coarser knot vector.
//
// Let u = u_r, its last copy, have multiplicity s. A curve over the knots without u_r has points Q with
//   P_i = a_i Q_i + (1 - a_i) Q_{i-1},  r - d <= i <= r - s,  a_i = (u - v_i) / (v_{i+d} - v_i),
// v the coarser knots (Boehm's insertion read backwards): one equation more than unknowns. Those before one
// equation, i = c, are solved from the left, those after it from the right; what it lacks itself is e_c, and
// the curve moves by N_c(u) e_c, at most |e_c| in each coordinate (Tiller 1992; Piegl, Tiller 1997, algorithm
// A5.8, with c in the middle). The equations are dependent with factors y, y_{i+1} / y_i = -a_i / (1 -
// a_{i+1}), so that y_c e_c is the same for all c: the one with the largest |y_c| moves the curve least, and
// nowhere divides by what is small beside it. For s = d + 1 there is no unknown: the two points at the jump
// become one.

#include "spline/curve.h"

namespace gcslab {

template <class T>
struct KnotRemoval {
  BSplineCurve<T> curve;
  int removed;    ///< how many knots
  T error_bound;  ///< no coordinate of the curve moved by more, anywhere
};

namespace spline_detail {

/// The equation with the largest |y|.
template <class T, class Weight>
std::size_t equation_left_open(std::size_t first, std::size_t last, const Weight& weight) {
  const T one = whole_number<T>(1);
  T factor = one;  // |y_i|
  T largest = one;
  std::size_t result = first;
  for (std::size_t i = first; i < last; ++i) {
    factor = factor * weight(i) / (one - weight(i + 1));
    if (!surely_less(largest, factor)) continue;
    largest = factor;
    result = i + 1;
  }
  return result;
}

/// The points without one knot, and the largest coordinate of |e|.
template <class T>
KnotRemoval<T> without_last_copy(const BSplineCurve<T>& curve, std::size_t r, std::size_t s) {
  const auto degree = static_cast<std::size_t>(curve.degree());
  std::vector<T> knots = curve.knots.knots();
  const T u = knots[r];
  knots.erase(knots.begin() + static_cast<std::ptrdiff_t>(r));
  const Matrix<T>& points = curve.points;
  Matrix<T> result(points.rows() - 1, curve.dimension());
  const std::size_t first = r - degree;  // of the equations
  const std::size_t last = r - s;        // of them; first - 1 for a jump
  const T one = whole_number<T>(1);
  const auto weight = [&](std::size_t i) { return T((u - knots[i]) / (knots[i + degree] - knots[i])); };
  const std::size_t open = equation_left_open<T>(first, last, weight);
  T error = whole_number<T>(0);
  for (std::size_t c = 0; c < curve.dimension(); ++c) {
    for (std::size_t i = 0; i < first; ++i) result(i, c) = points(i, c);
    for (std::size_t i = last + 1; i < points.rows(); ++i) {
      if (i > first) result(i - 1, c) = points(i, c);
    }
    for (std::size_t i = first; i < open; ++i)
      result(i, c) = (points(i, c) - (one - weight(i)) * result(i - 1, c)) / weight(i);
    for (std::size_t i = last; i > open; --i)
      result(i - 1, c) = (points(i, c) - weight(i) * result(i, c)) / (one - weight(i));
    T difference = whole_number<T>(0);
    if (last + 1 == first) {
      difference = points(first, c) - points(first - 1, c);
    } else {
      difference =
          points(open, c) - (weight(open) * result(open, c) + (one - weight(open)) * result(open - 1, c));
    }
    error = max(error, T(abs(difference)));
  }
  return {BSplineCurve<T>(KnotVector<T>(curve.degree(), std::move(knots)), std::move(result)), 1, error};
}

}  // namespace spline_detail

/// The curve with the knot u taken out as often as asked, or as often as the sum of the error bounds stays
/// within the tolerance. Throws InputError unless u is a knot strictly inside the domain.
template <class T>
KnotRemoval<T> without_knot(const BSplineCurve<T>& curve, const T& u, int times, const T& tolerance) {
  const std::vector<DistinctKnot<T>> knots = curve.knots.interior();
  const auto knot =
      std::find_if(knots.begin(), knots.end(), [&](const auto& other) { return same_knot(other.value, u); });
  if (knot == knots.end())
    throw InputError("removal of " + number_text(u) + ": expected a knot strictly inside of the domain [" +
                     number_text(curve.knots.lower()) + ", " + number_text(curve.knots.upper()) + "]");
  KnotRemoval<T> result{curve, 0, whole_number<T>(0)};
  for (int s = knot->multiplicity; s > 0 && result.removed < times; --s) {
    const auto copies = static_cast<std::size_t>(s);
    KnotRemoval<T> next = spline_detail::without_last_copy(result.curve, knot->first + copies - 1, copies);
    const T bound = result.error_bound + next.error_bound;
    if (!surely_at_most(bound, tolerance)) break;
    result = {std::move(next.curve), result.removed + 1, bound};
  }
  return result;
}

/// The curve without the knots inside its domain that it does not need, from left to right: the sum of all
/// error bounds stays within the tolerance.
template <class T>
KnotRemoval<T> simplified(const BSplineCurve<T>& curve, const T& tolerance) {
  KnotRemoval<T> result{curve, 0, whole_number<T>(0)};
  for (const DistinctKnot<T>& knot : curve.knots.interior()) {
    KnotRemoval<T> next =
        without_knot(result.curve, knot.value, knot.multiplicity, T(tolerance - result.error_bound));
    result = {std::move(next.curve), result.removed + next.removed, T(result.error_bound + next.error_bound)};
  }
  return result;
}

}  // namespace gcslab
