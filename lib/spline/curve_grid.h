#pragma once

// A curve at many ordered parameters.
//
// One pass over the spans: each span that has parameters is brought to Bernstein form once, and evaluated in
// O(d) a coordinate (bezier_pieces.h). The values differ from de Boor's by rounding alone; over sets they
// enclose the exact ones.

#include "spline/bezier_pieces.h"

namespace gcslab {

namespace spline_detail {

/// The number of parameters from the first one on that do not decrease and surely lie on a span, the first
/// one included.
template <class T>
std::size_t parameters_on_span(const KnotVector<T>& knots, std::size_t span, std::span<const T> parameters) {
  const T& end = knots[span + 1];
  std::size_t count = 1;
  while (count < parameters.size() && surely_less(parameters[count], end) &&
         surely_at_most(parameters[count - 1], parameters[count]))
    ++count;
  return count;
}

}  // namespace spline_detail

/// P at each of the parameters, which do not decrease, one a row of `values`, which is made as large. Throws
/// InputError for a parameter that is outside of the domain or out of order.
template <class T>
void evaluate_on_grid(const BSplineCurve<T>& curve, std::span<const T> parameters, Matrix<T>& values) {
  if (values.rows() != parameters.size() || values.columns() != curve.dimension())
    values = Matrix<T>(parameters.size(), curve.dimension());
  for (std::size_t i = 0; i < parameters.size();) {
    if (i > 0 && surely_less(parameters[i], parameters[i - 1]))
      throw InputError("parameter " + std::to_string(i) + " is " + number_text(parameters[i]) + " after " +
                       number_text(parameters[i - 1]) + ": expected parameters that do not decrease");
    const SpanRange spans = curve.knots.find_spans(parameters[i]);
    if (spans.first != spans.last) {
      const std::vector<T> value = evaluate(curve, parameters[i]);
      std::copy(value.begin(), value.end(), values.row(i++).begin());
      continue;
    }
    BezierEvaluator<T> piece(bezier_piece(curve, spans.last));
    const std::size_t count =
        spline_detail::parameters_on_span<T>(curve.knots, spans.last, parameters.subspan(i));
    piece.evaluate(parameters.subspan(i, count), values.row(i).data());
    i += count;
  }
}

/// The same as a new matrix.
template <class T>
Matrix<T> evaluate_on_grid(const BSplineCurve<T>& curve, std::span<const T> parameters) {
  Matrix<T> values;
  evaluate_on_grid(curve, parameters, values);
  return values;
}

}  // namespace gcslab
