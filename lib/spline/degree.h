#pragma once

// Degree elevation and reduction.
//
// Elevation raises each knot's multiplicity by one, so that continuity is kept, and
//   Q_i = 1 / (d + 1) sum_j f(v_{i+1}, ..., without v_{i+j}, ..., v_{i+d+1}),  j = 1, ..., d + 1,
// where v are the raised knots and f is the blossom (Ramshaw 1989; Cohen, Lyche, Schumaker 1985). Dropping
// every (d + 1)-th knot of v leaves a refinement of the curve's knots, whose control points are those values
// of f: d + 1 refinements give them all (Prautzsch 1984). Every step is a convex combination.
//
// Reduction goes through the pieces: of the d + 1 equations c_0 = b_0,
//   b_i = i / d c_{i-1} + (1 - i / d) c_i,
// that say that a piece b has degree d - 1 (Forrest 1972), one in the middle, i = h, may fail by e, and the
// piece moves by B_h^d(t) e. Ends of pieces stay where they are.

#include "spline/bezier_pieces.h"

namespace gcslab {

namespace spline_detail {

/// Each distinct value once more.
template <class T>
std::vector<T> raised_knots(const KnotVector<T>& knots) {
  std::vector<T> result;
  for (const DistinctKnot<T>& knot : knots.distinct())
    result.insert(result.end(), static_cast<std::size_t>(knot.multiplicity) + 1, knot.value);
  return result;
}

/// Those of `finer` that `knots` does not have, both ascending.
template <class T>
std::vector<T> added_knots(const std::vector<T>& finer, const std::vector<T>& knots) {
  std::vector<T> result;
  std::size_t i = 0;
  for (const T& knot : finer) {
    if (i < knots.size() && same_knot(knots[i], knot)) {
      ++i;
    } else {
      result.push_back(knot);
    }
  }
  return result;
}

/// Of a clamped curve without jumps.
template <class T>
BSplineCurve<T> elevated_once(const BSplineCurve<T>& curve) {
  const auto order = static_cast<std::size_t>(curve.degree()) + 1;
  std::vector<T> raised = raised_knots(curve.knots);
  const std::size_t inner = raised.size() - 2;  // knots 1, ..., inner are arguments of blossoms
  Matrix<T> points(inner - order + 1, curve.dimension(), whole_number<T>(0));
  for (std::size_t dropped = 0; dropped < order; ++dropped) {
    std::vector<T> finer{raised.front()};
    for (std::size_t i = 0; i < inner; ++i) {
      if (i % order != dropped) finer.push_back(raised[i + 1]);
    }
    finer.push_back(raised.back());
    const BSplineCurve<T> refinement = refined(curve, added_knots(finer, curve.knots.knots()));
    for (std::size_t i = 0; i < points.rows(); ++i) {
      const std::size_t start = i - (i + order - 1 - dropped) / order;  // kept ones among the first i
      for (std::size_t c = 0; c < points.columns(); ++c)
        points(i, c) = points(i, c) + refinement.points(start, c);
    }
  }
  for (std::size_t i = 0; i < points.rows(); ++i) {
    for (T& coordinate : points.row(i)) coordinate = coordinate / whole_number<T>(static_cast<long>(order));
  }
  return BSplineCurve<T>(KnotVector<T>(curve.degree() + 1, std::move(raised)), std::move(points));
}

/// max B_h^d = B_h^d(h / d).
template <class T>
T largest_bernstein_value(long d, long h) {
  T value = whole_number<T>(1);
  for (long i = 1; i <= h; ++i)
    value = value * whole_number<T>(d - h + i) / whole_number<T>(i) * whole_number<T>(h) / whole_number<T>(d);
  for (long i = 0; i < d - h; ++i) value = value * whole_number<T>(d - h) / whole_number<T>(d);
  return value;
}

/// The piece with one degree less, and a bound of what its coordinates moved by.
template <class T>
std::pair<BezierPiece<T>, T> reduced_piece(const BezierPiece<T>& piece) {
  const auto d = static_cast<long>(piece.points.rows()) - 1;
  const long middle = d / 2;
  const Matrix<T>& b = piece.points;
  BezierPiece<T> result{piece.start, piece.end, Matrix<T>(b.rows() - 1, b.columns())};
  Matrix<T>& reduced = result.points;
  const T degree = whole_number<T>(d);
  T error = whole_number<T>(0);
  for (std::size_t c = 0; c < b.columns(); ++c) {
    const auto at = [&](long i) -> T& { return reduced(static_cast<std::size_t>(i), c); };
    const auto given = [&](long i) -> const T& { return b(static_cast<std::size_t>(i), c); };
    at(0) = given(0);
    for (long i = 1; i < middle; ++i)
      at(i) = (degree * given(i) - whole_number<T>(i) * at(i - 1)) / whole_number<T>(d - i);
    at(d - 1) = given(d);
    for (long i = d - 1; i > middle; --i)
      at(i - 1) = (degree * given(i) - whole_number<T>(d - i) * at(i)) / whole_number<T>(i);
    const T difference =
        given(middle) -
        (whole_number<T>(middle) * at(middle - 1) + whole_number<T>(d - middle) * at(middle)) / degree;
    error = max(error, T(abs(difference)));
  }
  return {std::move(result), T(error * largest_bernstein_value<T>(d, middle))};
}

}  // namespace spline_detail

/// The same curve, clamped, with a degree higher by `by` >= 0; every multiplicity inside the domain is higher
/// by as much. Throws InputError for a negative number.
template <class T>
BSplineCurve<T> elevated(const BSplineCurve<T>& curve, int by = 1) {
  if (by < 0) throw InputError("degree elevation by " + std::to_string(by) + ": expected 0 or more");
  if (by == 0) return curve;
  std::vector<BSplineCurve<T>> parts = spline_detail::cut_at_full_knots(clamped(curve));
  for (BSplineCurve<T>& part : parts) {
    for (int i = 0; i < by; ++i) part = spline_detail::elevated_once(part);
  }
  return joined(parts);
}

/// A curve of one degree less near the given one, clamped, with the fewest knots that the tolerance allows:
/// the error bound is at most the larger of the tolerance and what the pieces must move by. Exact where the
/// curve has a lower degree. Over doubles give a tolerance of some roundings, or no knot will go. `removed`
/// counts the knots taken out between the pieces. Throws InputError for a degree below 2.
template <class T>
KnotRemoval<T> reduced(const BSplineCurve<T>& curve, const T& tolerance) {
  if (curve.degree() < 2)
    throw InputError("degree reduction: the curve has degree " + std::to_string(curve.degree()) +
                     ", expected 2 at least");
  T error = whole_number<T>(0);
  std::vector<BezierPiece<T>> pieces;
  for (const BezierPiece<T>& piece : bezier_pieces(curve)) {
    auto [reduced_one, moved] = spline_detail::reduced_piece(piece);
    pieces.push_back(std::move(reduced_one));
    error = max(error, moved);
  }
  const T left = max(T(tolerance - error), whole_number<T>(0));
  KnotRemoval<T> result = curve_from_pieces(pieces, left);
  result.error_bound = result.error_bound + error;
  return result;
}

}  // namespace gcslab
