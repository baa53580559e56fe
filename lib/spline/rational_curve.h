#pragma once

// Rational B-spline curves (NURBS).
//
//   P(u) = sum_i w_i N_i(u) P_i / sum_i w_i N_i(u),  w_i > 0,
//
// stored as the curve (w_i P_i, w_i) in one dimension more: what is done to knots and degree is done to that
// curve. Derivatives: Leibniz's rule on P w = A, that is (Piegl, Tiller 1997, equation 4.8)
//   P^(k) = (A^(k) - sum_i binomial(k, i) w^(i) P^(k-i)) / w,  i = 1, ..., k.

#include "spline/curve_grid.h"
#include "spline/degree.h"

namespace gcslab {

template <class T>
struct RationalCurve {
  BSplineCurve<T> homogeneous;  ///< rows (w x, w y, ..., w)

  /// Throws InputError unless it has two dimensions at least and all weights are positive.
  explicit RationalCurve(BSplineCurve<T> homogeneous_curve);

  int degree() const { return homogeneous.degree(); }
  std::size_t dimension() const { return homogeneous.dimension() - 1; }
  const T& weight(std::size_t i) const { return homogeneous.points(i, dimension()); }
};

/// Knots of any of the curves.
template <class T>
const KnotVector<T>& knots_of(const BSplineCurve<T>& curve) {
  return curve.knots;
}
template <class T>
const KnotVector<T>& knots_of(const RationalCurve<T>& curve) {
  return curve.homogeneous.knots;
}

namespace spline_detail {

/// Throws InputError unless the last coordinate of each row is positive.
template <class T>
void check_weights(const Matrix<T>& homogeneous) {
  if (homogeneous.columns() < 2)
    throw InputError("homogeneous points have 1 coordinate, expected 2 at least: a point and its weight");
  for (std::size_t i = 0; i < homogeneous.rows(); ++i) {
    const T& weight = homogeneous(i, homogeneous.columns() - 1);
    if (!surely_less(whole_number<T>(0), weight))
      throw InputError("weight " + std::to_string(i) + " is " + number_text(weight) +
                       ", expected a positive number");
  }
}

/// (w P, w), one a row.
template <class T>
Matrix<T> homogeneous_points(const Matrix<T>& points, const std::vector<T>& weights) {
  if (weights.size() != points.rows())
    throw InputError(std::to_string(weights.size()) + " weights given, expected " +
                     std::to_string(points.rows()) + ", one a control point");
  Matrix<T> result(points.rows(), points.columns() + 1);
  for (std::size_t i = 0; i < points.rows(); ++i) {
    for (std::size_t c = 0; c < points.columns(); ++c) result(i, c) = weights[i] * points(i, c);
    result(i, points.columns()) = weights[i];
  }
  return result;
}

}  // namespace spline_detail

template <class T>
RationalCurve<T>::RationalCurve(BSplineCurve<T> homogeneous_curve)
    : homogeneous(std::move(homogeneous_curve)) {
  spline_detail::check_weights(homogeneous.points);
}

/// From points and weights. Throws InputError as BSplineCurve and RationalCurve, and for a wrong number of
/// weights.
template <class T>
RationalCurve<T> rational_curve(const KnotVector<T>& knots, const Matrix<T>& points,
                                const std::vector<T>& weights) {
  return RationalCurve<T>(BSplineCurve<T>(knots, spline_detail::homogeneous_points(points, weights)));
}

/// The same curve in another number type, as converted_number.
template <class To, class From>
RationalCurve<To> converted(const RationalCurve<From>& curve) {
  return RationalCurve<To>(converted<To>(curve.homogeneous));
}

/// Row r: the r-th derivative of P at u, r = 0, ..., order. Throws InputError outside of the domain.
template <class T>
Matrix<T> derivatives(const RationalCurve<T>& curve, const T& u, int order) {
  const Matrix<T> given = derivatives(curve.homogeneous, u, order);
  const std::size_t w = curve.dimension();
  Matrix<T> result(given.rows(), w);
  for (std::size_t k = 0; k < given.rows(); ++k) {
    for (std::size_t c = 0; c < w; ++c) {
      T numerator = given(k, c);
      T binomial = whole_number<T>(1);
      for (std::size_t i = 1; i <= k; ++i) {
        binomial =
            binomial * whole_number<T>(static_cast<long>(k - i + 1)) / whole_number<T>(static_cast<long>(i));
        numerator = numerator - binomial * given(i, w) * result(k - i, c);
      }
      result(k, c) = numerator / given(0, w);
    }
  }
  return result;
}

/// P(u). Throws InputError outside of the domain.
template <class T>
std::vector<T> evaluate(const RationalCurve<T>& curve, const T& u) {
  std::vector<T> value = evaluate(curve.homogeneous, u);
  for (std::size_t c = 0; c + 1 < value.size(); ++c) value[c] = value[c] / value.back();
  value.pop_back();
  return value;
}

/// P at each of the parameters, which do not decrease, one a row; errors as of curve_grid.h.
template <class T>
Matrix<T> evaluate_on_grid(const RationalCurve<T>& curve, std::span<const T> parameters) {
  const Matrix<T> values = evaluate_on_grid(curve.homogeneous, parameters);
  Matrix<T> result(values.rows(), curve.dimension());
  for (std::size_t i = 0; i < result.rows(); ++i) {
    for (std::size_t c = 0; c < result.columns(); ++c)
      result(i, c) = values(i, c) / values(i, result.columns());
  }
  return result;
}

/// The operations of knot_insertion.h, subdivision.h and degree.h, with their errors: weights stay positive,
/// since new ones are convex combinations of them.
template <class T>
RationalCurve<T> refined(const RationalCurve<T>& curve, const std::vector<T>& new_knots) {
  return RationalCurve<T>(refined(curve.homogeneous, new_knots));
}
template <class T>
RationalCurve<T> restricted(const RationalCurve<T>& curve, const T& lower, const T& upper) {
  return RationalCurve<T>(restricted(curve.homogeneous, lower, upper));
}
template <class T>
std::pair<RationalCurve<T>, RationalCurve<T>> subdivided(const RationalCurve<T>& curve, const T& u) {
  auto [left, right] = subdivided(curve.homogeneous, u);
  return {RationalCurve<T>(std::move(left)), RationalCurve<T>(std::move(right))};
}
template <class T>
RationalCurve<T> elevated(const RationalCurve<T>& curve, int by = 1) {
  return RationalCurve<T>(elevated(curve.homogeneous, by));
}
}  // namespace gcslab
