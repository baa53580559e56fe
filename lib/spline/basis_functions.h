#pragma once

// The B-spline basis functions that are not zero at a parameter, and their derivatives.
//
//   N_i^0(u) = 1 on span i, else 0,
//   N_i^p(u) = (u - u_i) / (u_{i+p} - u_i) N_i^(p-1)(u) + (u_{i+p+1} - u) / (u_{i+p+1} - u_{i+1})
//   N_{i+1}^(p-1)(u), d/du N_i^p = p (N_i^(p-1) / (u_{i+p} - u_i) - N_{i+1}^(p-1) / (u_{i+p+1} - u_{i+1})).
//
// (Cox 1972; de Boor 1972; Piegl, Tiller 1997, equations 2.5, 2.7 and algorithms A2.2, A2.3.) At a knot the
// derivatives are those of the span on the right, at the right end of the domain those on the left. Errors:
// as KnotVector::find_span, and InputError for a negative order.

#include "base/matrix.h"
#include "spline/knot_vector.h"

namespace gcslab {

/// Row r, column j: the r-th derivative of N_{first+j}.
template <class T>
struct BasisFunctions {
  std::size_t first;
  Matrix<T> derivatives;  ///< (order + 1) x (d + 1)
};

namespace spline_detail {

inline void check_derivative_order(int order) {
  if (order < 0) throw InputError("derivative of order " + std::to_string(order) + ": expected 0 or more");
}

/// Degree p - 1 to degree p on span k, in place: values holds N_{k-p+1}, ..., N_k and becomes one longer.
template <class T>
void raise_values(const KnotVector<T>& knots, std::size_t k, const T& u, std::vector<T>& values) {
  const std::size_t p = values.size();
  values.push_back(whole_number<T>(0));
  T carried = whole_number<T>(0);
  for (std::size_t j = 0; j < p; ++j) {  // N_{i}^(p-1), i = k - p + 1 + j, feeds N_{i-1}^p and N_i^p
    const std::size_t i = k + 1 + j - p;
    const T share = values[j] / (knots[i + p] - knots[i]);
    values[j] = carried + (knots[i + p] - u) * share;
    carried = (u - knots[i]) * share;
  }
  values[p] = carried;
}

/// A derivative of degree p - 1 to the next one of degree p, likewise.
template <class T>
void raise_derivative(const KnotVector<T>& knots, std::size_t k, std::vector<T>& values) {
  const std::size_t p = values.size();
  values.push_back(whole_number<T>(0));
  T carried = whole_number<T>(0);
  for (std::size_t j = 0; j < p; ++j) {
    const std::size_t i = k + 1 + j - p;
    const T share = values[j] * whole_number<T>(static_cast<long>(p)) / (knots[i + p] - knots[i]);
    values[j] = carried - share;
    carried = share;
  }
  values[p] = carried;
}

}  // namespace spline_detail

/// Of the polynomials that the basis functions are on one non-empty span; u may lie outside of it.
template <class T>
BasisFunctions<T> basis_functions_on_span(const KnotVector<T>& knots, std::size_t span, const T& u,
                                          int order) {
  spline_detail::check_derivative_order(order);
  const auto degree = static_cast<std::size_t>(knots.degree());
  const auto rows = static_cast<std::size_t>(order) + 1;
  BasisFunctions<T> result{span - degree, Matrix<T>(rows, degree + 1, whole_number<T>(0))};
  std::vector<T> values{whole_number<T>(1)};
  for (std::size_t p = 0; p <= degree; ++p) {
    const std::size_t r = degree - p;
    if (r < rows) {
      std::vector<T> raised = values;
      for (std::size_t i = 0; i < r; ++i) spline_detail::raise_derivative(knots, span, raised);
      std::copy(raised.begin(), raised.end(), result.derivatives.row(r).begin());
    }
    if (p < degree) spline_detail::raise_values(knots, span, u, values);
  }
  return result;
}

/// Values (row 0) and derivatives up to an order at u.
template <class T>
BasisFunctions<T> basis_functions(const KnotVector<T>& knots, const T& u, int order = 0) {
  return basis_functions_on_span(knots, knots.find_span(u), u, order);
}

}  // namespace gcslab
