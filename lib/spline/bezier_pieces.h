#pragma once

// The polynomial pieces of a curve in Bernstein form, and curves made of pieces.
//
//   P(u) = sum_i B_i^d(t) b_i,  t = (u - start) / (end - start),  b_i the blossom with i arguments `end`.
//
// A piece is evaluated by the scheme (Farin 2002, section 5.6)
//   p <- p s + binomial(d, i) t^i b_i,  s = (end - u) / (end - start),  i = 1, ..., d,
// which has no cancellation between basis functions for any degree, and costs O(d) a coordinate where de
// Boor's triangle costs O(d^2) and a division for each of its entries.

#include "spline/knot_removal.h"
#include "spline/subdivision.h"

namespace gcslab {

template <class T>
struct BezierPiece {
  T start;
  T end;
  Matrix<T> points;  ///< (d + 1) x dimension
};

/// The piece of one non-empty span.
template <class T>
BezierPiece<T> bezier_piece(const BSplineCurve<T>& curve, std::size_t span) {
  const auto degree = static_cast<std::size_t>(curve.degree());
  BezierPiece<T> piece{curve.knots[span], curve.knots[span + 1], Matrix<T>(degree + 1, curve.dimension())};
  Matrix<T> work;
  for (std::size_t i = 0; i <= degree; ++i) {
    blossom_on_span(
        curve, span, [&](std::size_t j) -> const T& { return j < i ? piece.end : piece.start; }, work);
    const auto point = work.row(degree);
    std::copy(point.begin(), point.end(), piece.points.row(i).begin());
  }
  return piece;
}

/// One a non-empty span of the domain, from left to right.
template <class T>
std::vector<BezierPiece<T>> bezier_pieces(const BSplineCurve<T>& curve) {
  std::vector<BezierPiece<T>> pieces;
  for (const std::size_t span : curve.knots.spans()) pieces.push_back(bezier_piece(curve, span));
  return pieces;
}

/// The piece as a curve of its own.
template <class T>
BSplineCurve<T> curve_of_piece(const BezierPiece<T>& piece) {
  const std::size_t order = piece.points.rows();
  std::vector<T> knots(order, piece.start);
  knots.insert(knots.end(), order, piece.end);
  return BSplineCurve<T>(KnotVector<T>(static_cast<int>(order) - 1, std::move(knots)), piece.points);
}

/// The curve that the pieces are, one after the other, with the fewest knots: knots are removed while the
/// curve moves by no more than the tolerance in each coordinate (0: as exact arithmetic tells), so that the
/// knot vector that pieces were taken from comes back, clamped, without knots that it did not need. Throws
/// InputError unless each piece starts where the one before it ends, with its degree and dimension.
template <class T>
KnotRemoval<T> curve_from_pieces(const std::vector<BezierPiece<T>>& pieces, const T& tolerance) {
  std::vector<BSplineCurve<T>> curves;
  for (const BezierPiece<T>& piece : pieces) curves.push_back(curve_of_piece(piece));
  return simplified(joined(curves), tolerance);
}

/// A piece made ready for many parameters. It belongs to one thread.
template <class T>
class BezierEvaluator {
 public:
  explicit BezierEvaluator(const BezierPiece<T>& piece)
      : start_(piece.start),
        end_(piece.end),
        scale_(whole_number<T>(1) / (piece.end - piece.start)),
        weighted_(piece.points) {
    const auto degree = static_cast<long>(weighted_.rows()) - 1;
    T binomial = whole_number<T>(1);
    for (long i = 0; i <= degree; ++i) {
      for (T& coordinate : weighted_.row(static_cast<std::size_t>(i))) coordinate = binomial * coordinate;
      binomial = binomial * whole_number<T>(degree - i) / whole_number<T>(i + 1);
    }
  }

  /// The values at the parameters, one after the other; `values` has room for all of their coordinates.
  void evaluate(std::span<const T> parameters, T* values) {
    for (std::size_t i = 0; i < parameters.size(); i += kBlock) {
      const std::size_t count = std::min(kBlock, parameters.size() - i);
      prepare(parameters.subspan(i, count));
      for (std::size_t c = 0; c < weighted_.columns(); ++c)
        evaluate_coordinate(c, count, values + i * weighted_.columns() + c);
    }
  }

 private:
  /// Parameters that are worked on together, one operation on all before the next, so that compilers make
  /// vector code of it.
  static constexpr std::size_t kBlock = 64;

  /// s and the powers of t.
  void prepare(std::span<const T> parameters) {
    const std::size_t degree = weighted_.rows() - 1;
    if (powers_.columns() < parameters.size()) {
      powers_ = Matrix<T>(degree, parameters.size());
      complements_.resize(parameters.size());
      sums_.resize(parameters.size());
    }
    for (std::size_t j = 0; j < parameters.size(); ++j) complements_[j] = (end_ - parameters[j]) * scale_;
    if (degree == 0) return;
    T* first = powers_.row(0).data();
    for (std::size_t j = 0; j < parameters.size(); ++j) first[j] = (parameters[j] - start_) * scale_;
    for (std::size_t i = 1; i < degree; ++i) {
      const T* last = powers_.row(i - 1).data();
      T* next = powers_.row(i).data();
      for (std::size_t j = 0; j < parameters.size(); ++j) next[j] = last[j] * first[j];
    }
  }

  void evaluate_coordinate(std::size_t c, std::size_t count, T* values) {
    T* sums = sums_.data();
    const T* s = complements_.data();
    for (std::size_t j = 0; j < count; ++j) sums[j] = weighted_(0, c);
    for (std::size_t i = 1; i < weighted_.rows(); ++i) {
      const T coefficient = weighted_(i, c);
      const T* power = powers_.row(i - 1).data();
      for (std::size_t j = 0; j < count; ++j) sums[j] = sums[j] * s[j] + power[j] * coefficient;
    }
    for (std::size_t j = 0; j < count; ++j) values[j * weighted_.columns()] = sums[j];
  }

  T start_;
  T end_;
  T scale_;
  Matrix<T> weighted_;  ///< binomial(d, i) b_i
  Matrix<T> powers_;    ///< of t, from the first on, one parameter a column
  std::vector<T> complements_;
  std::vector<T> sums_;
};

}  // namespace gcslab
