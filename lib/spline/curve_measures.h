#pragma once

// Lengths and curvatures of curves, polynomial and rational.
//
// Length: the integral of |P'| over each span by itself, where |P'| is smooth but for cusps. Curvature: for
// two coordinates (x'y'' - y'x'') / |P'|^3, positive where the curve turns left; in any dimension
// sqrt(|P'|^2 |P''|^2 - (P'.P'')^2) / |P'|^3 (do Carmo 1976, section 1.5).

#include "spline/quadrature.h"
#include "spline/rational_curve.h"

namespace gcslab {

namespace spline_detail {

template <class T>
T inner_product(std::span<const T> a, std::span<const T> b) {
  T sum = a[0] * b[0];
  for (std::size_t c = 1; c < a.size(); ++c) sum = sum + a[c] * b[c];
  return sum;
}

template <class T>
T squared_speed(const Matrix<T>& derivatives, const T& u) {
  const std::span<const T> velocity = derivatives.row(1);
  const T square = inner_product(velocity, velocity);
  if (!surely_less(whole_number<T>(0), square))
    throw NotApplicable("curvature at parameter " + number_text(u) + ": the first derivative vanishes there");
  return square;
}

}  // namespace spline_detail

/// The length from parameter a to parameter b >= a; the tolerance is absolute. Throws InputError outside of
/// the domain, for b < a, and for a tolerance that is not positive.
template <class Curve>
Integral arc_length(const Curve& curve, double a, double b, double tolerance) {
  const KnotVector<double>& knots = knots_of(curve);
  static_cast<void>(knots.find_span(a) + knots.find_span(b));
  if (b < a)
    throw InputError("length from " + number_text(a) + " to " + number_text(b) +
                     ": expected an end after its start");
  if (!(tolerance > 0))
    throw InputError("tolerance " + number_text(tolerance) + ": expected a positive number");
  const auto speed = [&](double u) {
    const Matrix<double> rows = derivatives(curve, u, 1);
    return std::sqrt(spline_detail::inner_product<double>(rows.row(1), rows.row(1)));
  };
  Integral sum;
  for (const std::size_t k : knots.spans()) {
    const double start = std::max(a, knots[k]);
    const double end = std::min(b, knots[k + 1]);
    if (!(start < end)) continue;
    const Integral part = adaptive_integral(speed, start, end, tolerance * (end - start) / (b - a));
    sum = {sum.value + part.value, sum.error_estimate + part.error_estimate};
  }
  return sum;
}

/// The length of the whole curve.
template <class Curve>
Integral arc_length(const Curve& curve, double tolerance) {
  return arc_length(curve, knots_of(curve).lower(), knots_of(curve).upper(), tolerance);
}

/// Of a curve in the plane, for types with a square root. Throws InputError outside of the domain and in
/// other dimensions, NotApplicable where P' (over sets: perhaps) vanishes.
template <class Curve, class T>
T signed_curvature(const Curve& curve, const T& u) {
  const Matrix<T> rows = derivatives(curve, u, 2);
  if (rows.columns() != 2)
    throw InputError("signed curvature: the curve has " + std::to_string(rows.columns()) +
                     " coordinates, expected 2");
  const T square = spline_detail::squared_speed(rows, u);
  return T((rows(1, 0) * rows(2, 1) - rows(1, 1) * rows(2, 0)) / (square * sqrt(square)));
}

/// Of a curve in any dimension; errors as signed_curvature.
template <class Curve, class T>
T curvature(const Curve& curve, const T& u) {
  const Matrix<T> rows = derivatives(curve, u, 2);
  const T square = spline_detail::squared_speed(rows, u);
  // By Lagrange's identity a sum of squares, so that rounding makes no negative number of it.
  T sum = whole_number<T>(0);
  for (std::size_t i = 0; i < rows.columns(); ++i) {
    for (std::size_t j = i + 1; j < rows.columns(); ++j)
      sum = sum + sqr(T(rows(1, i) * rows(2, j) - rows(1, j) * rows(2, i)));
  }
  return T(sqrt(sum) / (square * sqrt(square)));
}

}  // namespace gcslab
