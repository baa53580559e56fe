#pragma once

// Tensor product B-spline surfaces, polynomial and rational.
//
//   P(u, v) = sum_i sum_j N_i(u) M_j(v) P_ij,
//
// N and M the bases of two knot vectors. In direction u a surface is a curve whose control points are whole
// rows of the grid, in direction v one whose control points are columns: every operation on knots and degrees
// is that of curves, applied once to all coordinates of such a curve (`in_direction`). Over set-valued number
// types results enclose, as those of curves. Sources: Piegl, Tiller 1997, chapter 3; Celikbas 2003, section
// 1.4.

#include "spline/rational_curve.h"

namespace gcslab {

enum class Direction { u, v };

template <class T>
struct BSplineSurface {
  KnotVector<T> u;
  KnotVector<T> v;
  Matrix<T> points;  ///< row i v.size() + j is P_ij

  /// Throws InputError unless there are u.size() v.size() finite points, in one dimension at least.
  BSplineSurface(KnotVector<T> u_knots, KnotVector<T> v_knots, Matrix<T> control_points);

  std::size_t dimension() const { return points.columns(); }
};

namespace spline_detail {

/// Entry ((i b) + j) c + k of an a x b x c array goes to ((j a) + i) c + k.
template <class T>
Matrix<T> with_exchanged_rows(const Matrix<T>& points, std::size_t a, std::size_t b) {
  Matrix<T> result(points.rows(), points.columns());
  for (std::size_t i = 0; i < a; ++i) {
    for (std::size_t j = 0; j < b; ++j)
      std::copy(points.row(i * b + j).begin(), points.row(i * b + j).end(), result.row(j * a + i).begin());
  }
  return result;
}

/// The same entries in order, in rows of another length.
template <class T>
Matrix<T> reshaped(const Matrix<T>& points, std::size_t rows) {
  const std::size_t entries = points.rows() * points.columns();
  Matrix<T> result(rows, entries / rows);
  std::copy(points.data(), points.data() + entries, result.data());
  return result;
}

}  // namespace spline_detail

template <class T>
BSplineSurface<T>::BSplineSurface(KnotVector<T> u_knots, KnotVector<T> v_knots, Matrix<T> control_points)
    : u(std::move(u_knots)), v(std::move(v_knots)), points(std::move(control_points)) {
  if (points.rows() != u.size() * v.size())
    throw InputError("surface: " + std::to_string(points.rows()) + " control points given, expected " +
                     std::to_string(u.size()) + " x " + std::to_string(v.size()) + " = " +
                     std::to_string(u.size() * v.size()));
  static_cast<void>(BSplineCurve<T>(u, spline_detail::reshaped(points, u.size())));  // checks the numbers
}

/// The surface as a curve in one direction; its points have the coordinates of a whole row or column.
template <class T>
BSplineCurve<T> curve_in_direction(const BSplineSurface<T>& surface, Direction direction) {
  if (direction == Direction::u)
    return BSplineCurve<T>(surface.u, spline_detail::reshaped(surface.points, surface.u.size()));
  return BSplineCurve<T>(
      surface.v, spline_detail::reshaped(
                     spline_detail::with_exchanged_rows(surface.points, surface.u.size(), surface.v.size()),
                     surface.v.size()));
}

/// The surface that such a curve is; `across` is the knot vector of the other direction.
template <class T>
BSplineSurface<T> surface_of_curve(const BSplineCurve<T>& curve, const KnotVector<T>& across,
                                   Direction direction) {
  Matrix<T> points = spline_detail::reshaped(curve.points, curve.knots.size() * across.size());
  if (direction == Direction::u) return BSplineSurface<T>(curve.knots, across, std::move(points));
  return BSplineSurface<T>(across, curve.knots,
                           spline_detail::with_exchanged_rows(points, curve.knots.size(), across.size()));
}

/// operation(curve) -> curve, applied in one direction: knot insertion, elevation, restriction, ....
template <class T, class Operation>
BSplineSurface<T> in_direction(const BSplineSurface<T>& surface, Direction direction,
                               const Operation& operation) {
  return surface_of_curve<T>(operation(curve_in_direction(surface, direction)),
                             direction == Direction::u ? surface.v : surface.u, direction);
}

/// The derivative of that order in u and in v at a point. Throws InputError outside of the domain.
template <class T>
std::vector<T> partial_derivative(const BSplineSurface<T>& surface, const T& u, const T& v, int order_u,
                                  int order_v) {
  return over_spans(surface.u, u, [&](std::size_t span_u, const T& part_u) {
    const BasisFunctions<T> rows = basis_functions_on_span(surface.u, span_u, part_u, order_u);
    return over_spans(surface.v, v, [&](std::size_t span_v, const T& part_v) {
      const BasisFunctions<T> columns = basis_functions_on_span(surface.v, span_v, part_v, order_v);
      std::vector<T> sum(surface.dimension(), whole_number<T>(0));
      for (std::size_t i = 0; i < rows.derivatives.columns(); ++i) {
        for (std::size_t j = 0; j < columns.derivatives.columns(); ++j) {
          const T factor = rows.derivatives(static_cast<std::size_t>(order_u), i) *
                           columns.derivatives(static_cast<std::size_t>(order_v), j);
          const auto point = surface.points.row((rows.first + i) * surface.v.size() + columns.first + j);
          for (std::size_t c = 0; c < sum.size(); ++c) sum[c] = sum[c] + factor * point[c];
        }
      }
      return sum;
    });
  });
}

/// P(u, v). Throws InputError outside of the domain.
template <class T>
std::vector<T> evaluate(const BSplineSurface<T>& surface, const T& u, const T& v) {
  return partial_derivative(surface, u, v, 0, 0);
}

/// The curve on the surface where the parameter of the direction has that value. Throws InputError outside of
/// the domain.
template <class T>
BSplineCurve<T> iso_curve(const BSplineSurface<T>& surface, Direction fixed, const T& value) {
  const std::vector<T> entries = evaluate(curve_in_direction(surface, fixed), value);
  const KnotVector<T>& across = fixed == Direction::u ? surface.v : surface.u;
  Matrix<T> points(across.size(), surface.dimension());
  std::copy(entries.begin(), entries.end(), points.data());
  return BSplineCurve<T>(across, std::move(points));
}

/// P(u_i, v_j) in row i count(v) + j, for parameters that do not decrease in either direction; one pass over
/// the spans in each (curve_grid.h). Throws InputError for a parameter outside of the domain or out of order.
template <class T>
Matrix<T> evaluate_on_grid(const BSplineSurface<T>& surface, std::span<const T> u, std::span<const T> v) {
  const Matrix<T> rows = evaluate_on_grid(curve_in_direction(surface, Direction::u), u);
  if (u.empty()) return Matrix<T>(0, surface.dimension());
  const Matrix<T> columns = spline_detail::with_exchanged_rows(
      spline_detail::reshaped(rows, u.size() * surface.v.size()), u.size(), surface.v.size());
  const BSplineCurve<T> across(surface.v, spline_detail::reshaped(columns, surface.v.size()));
  const Matrix<T> values = evaluate_on_grid(across, v);
  if (v.empty()) return Matrix<T>(0, surface.dimension());
  return spline_detail::with_exchanged_rows(spline_detail::reshaped(values, u.size() * v.size()), v.size(),
                                            u.size());
}

/// As refined, elevated and subdivided of curves, in one direction.
template <class T>
BSplineSurface<T> refined(const BSplineSurface<T>& surface, Direction direction,
                          const std::vector<T>& new_knots) {
  return in_direction(surface, direction,
                      [&](const BSplineCurve<T>& curve) { return refined(curve, new_knots); });
}
template <class T>
BSplineSurface<T> elevated(const BSplineSurface<T>& surface, Direction direction, int by = 1) {
  return in_direction(surface, direction, [&](const BSplineCurve<T>& curve) { return elevated(curve, by); });
}
template <class T>
std::pair<BSplineSurface<T>, BSplineSurface<T>> subdivided(const BSplineSurface<T>& surface,
                                                           Direction direction, const T& parameter) {
  const KnotVector<T>& across = direction == Direction::u ? surface.v : surface.u;
  const auto [before, after] = subdivided(curve_in_direction(surface, direction), parameter);
  return {surface_of_curve(before, across, direction), surface_of_curve(after, across, direction)};
}

/// The surface sum w_ij N_i M_j P_ij / sum w_ij N_i M_j, as a polynomial one in homogeneous coordinates:
/// knots and degrees are changed there.
template <class T>
struct RationalSurface {
  BSplineSurface<T> homogeneous;  ///< points (w x, w y, ..., w)

  /// Throws InputError unless it has two dimensions at least and all weights are positive.
  explicit RationalSurface(BSplineSurface<T> homogeneous_surface)
      : homogeneous(std::move(homogeneous_surface)) {
    spline_detail::check_weights(homogeneous.points);
  }
};

/// From points and weights, in the order of BSplineSurface. Throws InputError as these.
template <class T>
RationalSurface<T> rational_surface(const KnotVector<T>& u, const KnotVector<T>& v, const Matrix<T>& points,
                                    const std::vector<T>& weights) {
  return RationalSurface<T>(BSplineSurface<T>(u, v, spline_detail::homogeneous_points(points, weights)));
}

/// P(u, v). Throws InputError outside of the domain.
template <class T>
std::vector<T> evaluate(const RationalSurface<T>& surface, const T& u, const T& v) {
  std::vector<T> value = evaluate(surface.homogeneous, u, v);
  for (std::size_t c = 0; c + 1 < value.size(); ++c) value[c] = value[c] / value.back();
  value.pop_back();
  return value;
}

}  // namespace gcslab
