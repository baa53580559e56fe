#pragma once

// A curve at many ordered parameters.
//
// One pass over the spans: each span that has parameters is brought to Bernstein form once, and evaluated in
// O(d) a coordinate (bezier_pieces.h). The values differ from de Boor's by rounding alone; over sets they
// enclose the exact ones.

#include "spline/bezier_pieces.h"

namespace gcslab {

/// P at each of the parameters, which do not decrease, one a row. Throws InputError for a parameter that is
/// outside of the domain or out of order.
template <class T>
Matrix<T> evaluate_on_grid(const BSplineCurve<T>& curve, std::span<const T> parameters) {
  const KnotVector<T>& knots = curve.knots;
  Matrix<T> result(parameters.size(), curve.dimension());
  const auto is_on_span = [&](const T& u, std::size_t span) {
    return surely_at_most(knots[span], u) && surely_less(u, knots[span + 1]);
  };
  for (std::size_t i = 0; i < parameters.size();) {
    if (i > 0 && surely_less(parameters[i], parameters[i - 1]))
      throw InputError("parameter " + std::to_string(i) + " is " + number_text(parameters[i]) + " after " +
                       number_text(parameters[i - 1]) + ": expected parameters that do not decrease");
    const SpanRange spans = knots.find_spans(parameters[i]);
    if (spans.first != spans.last) {
      const std::vector<T> value = evaluate(curve, parameters[i]);
      std::copy(value.begin(), value.end(), result.row(i++).begin());
      continue;
    }
    const BezierEvaluator<T> piece(bezier_piece(curve, spans.last));
    do {
      piece.evaluate(parameters[i], result.row(i));
      ++i;
    } while (i < parameters.size() && is_on_span(parameters[i], spans.last) &&
             !surely_less(parameters[i], parameters[i - 1]));
  }
  return result;
}

}  // namespace gcslab
