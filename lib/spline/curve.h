#pragma once

// B-spline curves: evaluation, derivatives, the hodograph.
//
//   P(u) = sum_i N_i^d(u) P_i,  u in [u_d, u_{n+1}],  P_i a row of `points`.
//
// Over a set-valued number type results enclose those of all members of knots, points and parameter; a
// parameter that meets several spans gives the hull of its values on them. At a knot derivatives are those of
// the span on the right, at the right end of the domain those on the left. Sources: de Boor 1972; Ramshaw
// 1989 (blossoms); Piegl, Tiller 1997, chapter 3; Celikbas 2003, section 1.3.

#include <span>

#include "spline/basis_functions.h"

namespace gcslab {

template <class T>
struct BSplineCurve {
  KnotVector<T> knots;
  Matrix<T> points;  ///< one control point a row

  /// Throws InputError unless there is one finite point a basis function, in one dimension at least.
  BSplineCurve(KnotVector<T> knot_vector, Matrix<T> control_points);

  int degree() const { return knots.degree(); }
  std::size_t dimension() const { return points.columns(); }
};

/// Rows of equal length as a matrix. Throws InputError when they are not.
template <class T>
Matrix<T> matrix_of_rows(const std::vector<std::vector<T>>& rows) {
  Matrix<T> result(rows.size(), rows.empty() ? 0 : rows.front().size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (rows[i].size() != result.columns())
      throw InputError("point " + std::to_string(i) + " has " + std::to_string(rows[i].size()) +
                       " coordinates, expected " + std::to_string(result.columns()) + " as of point 0");
    std::copy(rows[i].begin(), rows[i].end(), result.row(i).begin());
  }
  return result;
}

template <class T>
BSplineCurve<T>::BSplineCurve(KnotVector<T> knot_vector, Matrix<T> control_points)
    : knots(std::move(knot_vector)), points(std::move(control_points)) {
  if (points.rows() != knots.size())
    throw InputError("curve: " + std::to_string(points.rows()) + " control points given, expected " +
                     std::to_string(knots.size()) + " (" + std::to_string(knots.knots().size()) +
                     " knots - degree " + std::to_string(degree()) + " - 1)");
  if (dimension() == 0) throw InputError("curve: control points have no coordinates, expected 1 at least");
  for (std::size_t i = 0; i < points.rows(); ++i) {
    for (std::size_t c = 0; c < dimension(); ++c) {
      if (!is_finite_number(points(i, c)))
        throw InputError("control point " + std::to_string(i) + ": coordinate " + std::to_string(c) + " is " +
                         number_text(points(i, c)) + ", expected a finite number");
    }
  }
}

/// The same curve in another number type, as converted_number.
template <class To, class From>
BSplineCurve<To> converted(const BSplineCurve<From>& curve) {
  Matrix<To> points(curve.points.rows(), curve.dimension());
  for (std::size_t i = 0; i < points.rows(); ++i) {
    for (std::size_t c = 0; c < points.columns(); ++c)
      points(i, c) = converted_number<To>(curve.points(i, c));
  }
  return BSplineCurve<To>(converted<To>(curve.knots), std::move(points));
}

/// The blossom of the curve's polynomial on a non-empty span at the parameters argument(0), ...,
/// argument(d - 1), by de Boor's triangle: the last row of `work`, which is made (d + 1) x dimension. Convex
/// combinations of control points where the parameters lie in the span.
template <class T, class Argument>
void blossom_on_span(const BSplineCurve<T>& curve, std::size_t span, const Argument& argument,
                     Matrix<T>& work) {
  const auto degree = static_cast<std::size_t>(curve.degree());
  const std::size_t dimension = curve.dimension();
  if (work.rows() != degree + 1 || work.columns() != dimension) work = Matrix<T>(degree + 1, dimension);
  const T* points = curve.points.row(span - degree).data();
  std::copy(points, points + (degree + 1) * dimension, work.data());
  const T one = whole_number<T>(1);
  for (std::size_t level = 1; level <= degree; ++level) {
    const T& u = argument(level - 1);
    for (std::size_t r = degree; r >= level; --r) {
      const std::size_t i = span - degree + r;
      const T& left = curve.knots[i];
      const T weight = (u - left) / (curve.knots[i + degree + 1 - level] - left);
      const T complement = one - weight;
      for (std::size_t c = 0; c < dimension; ++c)
        work(r, c) = complement * work(r - 1, c) + weight * work(r, c);
    }
  }
}

/// de Boor's algorithm for the polynomial of a span, as blossom_on_span.
template <class T>
void de_boor_on_span(const BSplineCurve<T>& curve, std::size_t span, const T& u, Matrix<T>& work) {
  blossom_on_span(
      curve, span, [&](std::size_t) -> const T& { return u; }, work);
}

/// f(span, part of u in it) as a vector; over sets the hull over all spans that u meets.
template <class T, class OnSpan>
std::vector<T> over_spans(const KnotVector<T>& knots, const T& u, const OnSpan& on_span) {
  const SpanRange range = knots.find_spans(u);
  if constexpr (!SetNumber<T>) {
    return on_span(range.last, u);
  } else {
    std::vector<T> result;
    for (std::size_t k = range.first; k <= range.last; ++k) {
      if (!knots.is_span(k)) continue;
      const std::vector<T> part = on_span(k, cut_to(u, knots[k], knots[k + 1]));
      for (std::size_t i = 0; i < part.size(); ++i) {
        if (result.size() <= i) {
          result.push_back(part[i]);
        } else {
          result[i] = joint_enclosure(result[i], part[i]);
        }
      }
    }
    return result;
  }
}

/// P(u), by de Boor's algorithm. Throws InputError for a parameter outside of the domain.
template <class T>
std::vector<T> evaluate(const BSplineCurve<T>& curve, const T& u) {
  return over_spans(curve.knots, u, [&](std::size_t span, const T& part) {
    Matrix<T> work;
    de_boor_on_span(curve, span, part, work);
    const auto value = work.row(work.rows() - 1);
    return std::vector<T>(value.begin(), value.end());
  });
}

/// Row r: the r-th derivative of P at u, r = 0, ..., order. Throws InputError as evaluate, and for a negative
/// order.
template <class T>
Matrix<T> derivatives(const BSplineCurve<T>& curve, const T& u, int order) {
  spline_detail::check_derivative_order(order);
  Matrix<T> result(static_cast<std::size_t>(order) + 1, curve.dimension(), whole_number<T>(0));
  const std::vector<T> entries = over_spans(curve.knots, u, [&](std::size_t span, const T& part) {
    const BasisFunctions<T> basis = basis_functions_on_span(curve.knots, span, part, order);
    std::vector<T> sums;
    for (std::size_t r = 0; r < result.rows(); ++r) {
      for (std::size_t c = 0; c < result.columns(); ++c) {
        T sum = basis.derivatives(r, 0) * curve.points(basis.first, c);
        for (std::size_t j = 1; j < basis.derivatives.columns(); ++j)
          sum = sum + basis.derivatives(r, j) * curve.points(basis.first + j, c);
        sums.push_back(sum);
      }
    }
    return sums;
  });
  std::copy(entries.begin(), entries.end(), result.data());
  return result;
}

/// The derivative as a curve of degree d - 1 over the same domain:
///   P'(u) = sum_i N_{i+1}^(d-1)(u) d (P_{i+1} - P_i) / (u_{i+d+1} - u_{i+1}).
/// A jump of P (a knot of multiplicity d + 1) becomes one of P'. Throws InputError for degree 0.
template <class T>
BSplineCurve<T> hodograph(const BSplineCurve<T>& curve) {
  if (curve.degree() == 0) throw InputError("hodograph: the curve has degree 0, expected 1 at least");
  const auto degree = static_cast<std::size_t>(curve.degree());
  const std::vector<T>& knots = curve.knots.knots();
  std::vector<T> lowered;
  std::vector<std::vector<T>> rows;
  for (std::size_t i = 0; i + 2 < knots.size(); ++i) {
    const bool is_function = i + 1 < curve.points.rows();
    if (is_function && same_knot(knots[i + 1], knots[i + degree + 1])) continue;  // of no support
    lowered.push_back(knots[i + 1]);
    if (!is_function) continue;
    const T factor = whole_number<T>(curve.degree()) / (knots[i + degree + 1] - knots[i + 1]);
    rows.emplace_back();
    for (std::size_t c = 0; c < curve.dimension(); ++c)
      rows.back().push_back(T(factor * (curve.points(i + 1, c) - curve.points(i, c))));
  }
  return BSplineCurve<T>(KnotVector<T>(curve.degree() - 1, std::move(lowered)), matrix_of_rows(rows));
}

}  // namespace gcslab
