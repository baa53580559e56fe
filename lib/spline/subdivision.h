#pragma once

// Parts of curves, and curves put together from parts.
//
// A knot of multiplicity d + 1 separates a curve: nothing to its left depends on points to its right. Parts
// are cut out after such knots are inserted at their ends (Boehm 1980; Celikbas 2003, figure 5).

#include <utility>

#include "spline/knot_insertion.h"

namespace gcslab {

namespace spline_detail {

/// Knots [first, last) with their points.
template <class T>
BSplineCurve<T> slice(const BSplineCurve<T>& curve, std::size_t first, std::size_t last) {
  const auto begin = curve.knots.knots().begin();
  std::vector<T> knots(begin + static_cast<std::ptrdiff_t>(first), begin + static_cast<std::ptrdiff_t>(last));
  const std::size_t rows = knots.size() - static_cast<std::size_t>(curve.degree()) - 1;
  Matrix<T> points(rows, curve.dimension());
  const T* source = curve.points.row(first).data();
  std::copy(source, source + rows * points.columns(), points.data());
  return BSplineCurve<T>(KnotVector<T>(curve.degree(), std::move(knots)), std::move(points));
}

/// The curve cut at its knots of multiplicity d + 1, which stand at both of its ends.
template <class T>
std::vector<BSplineCurve<T>> cut_at_full_knots(const BSplineCurve<T>& curve) {
  std::vector<BSplineCurve<T>> parts;
  const auto order = static_cast<std::size_t>(curve.degree()) + 1;
  std::size_t start = 0;
  for (const DistinctKnot<T>& knot : curve.knots.distinct()) {
    if (knot.first == start || static_cast<std::size_t>(knot.multiplicity) < order) continue;
    parts.push_back(slice(curve, start, knot.first + order));
    start = knot.first;
  }
  return parts;
}

/// How often each of the values is to be inserted to separate there.
template <class T>
std::vector<T> separating_knots(const KnotVector<T>& knots, const std::vector<T>& values) {
  std::vector<T> result;
  for (const T& value : values)
    result.insert(result.end(), static_cast<std::size_t>(knots.degree() + 1 - knots.multiplicity(value)),
                  value);
  return result;
}

}  // namespace spline_detail

/// The part of the curve from `lower` to `upper`, clamped. Throws InputError unless lower < upper, both in
/// the domain.
template <class T>
BSplineCurve<T> restricted(const BSplineCurve<T>& curve, const T& lower, const T& upper) {
  static_cast<void>(curve.knots.find_spans(lower));
  static_cast<void>(curve.knots.find_spans(upper));
  if (!surely_less(lower, upper))
    throw InputError("part of a curve from " + number_text(lower) + " to " + number_text(upper) +
                     ": expected an end after its start");
  const BSplineCurve<T> separated =
      refined(curve, spline_detail::separating_knots(curve.knots, {lower, upper}));
  std::size_t first = 0;
  std::size_t last = separated.knots.knots().size();
  while (!same_knot(separated.knots[first], lower)) ++first;
  while (!same_knot(separated.knots[last - 1], upper)) --last;
  return spline_detail::slice(separated, first, last);
}

/// The curve with a clamped knot vector, over its domain.
template <class T>
BSplineCurve<T> clamped(const BSplineCurve<T>& curve) {
  return restricted(curve, curve.knots.lower(), curve.knots.upper());
}

/// The parts of the curve before and after u, which together are the curve. Throws InputError unless u lies
/// strictly inside the domain.
template <class T>
std::pair<BSplineCurve<T>, BSplineCurve<T>> subdivided(const BSplineCurve<T>& curve, const T& u) {
  static_cast<void>(curve.knots.find_spans(u));
  if (!surely_less(curve.knots.lower(), u) || !surely_less(u, curve.knots.upper()))
    throw InputError("subdivision at " + number_text(u) +
                     ": expected a parameter strictly inside of the domain [" +
                     number_text(curve.knots.lower()) + ", " + number_text(curve.knots.upper()) + "]");
  return {restricted(curve, curve.knots.lower(), u), restricted(curve, u, curve.knots.upper())};
}

/// Clamped curves of one degree, each of which starts at the knot where the one before it ends, as one curve
/// with knots of multiplicity d + 1 between them. Throws InputError for others.
template <class T>
BSplineCurve<T> joined(const std::vector<BSplineCurve<T>>& parts) {
  if (parts.empty()) throw InputError("curves to join: none given, expected 1 at least");
  const BSplineCurve<T>& model = parts.front();
  std::vector<T> knots;
  std::vector<std::vector<T>> rows;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const BSplineCurve<T>& part = parts[i];
    if (part.degree() != model.degree() || part.dimension() != model.dimension() ||
        !part.knots.is_clamped() || (i > 0 && !same_knot(knots.back(), part.knots.lower())))
      throw InputError(
          "curves to join: curve " + std::to_string(i) +
          " does not go on where the one before it ends, clamped, with its degree and dimension");
    const auto begin = part.knots.knots().begin();
    knots.insert(knots.end(), i == 0 ? begin : begin + part.degree() + 1, part.knots.knots().end());
    for (std::size_t r = 0; r < part.points.rows(); ++r)
      rows.emplace_back(part.points.row(r).begin(), part.points.row(r).end());
  }
  return BSplineCurve<T>(KnotVector<T>(model.degree(), std::move(knots)), matrix_of_rows(rows));
}

}  // namespace gcslab
