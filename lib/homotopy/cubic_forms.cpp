#include "homotopy/cubic_forms.h"

#include "base/check.h"
#include "interval/rational.h"

namespace gcslab {

void CubicForms::add(std::size_t row, const Polynomial& polynomial, std::span<const std::size_t> variables) {
  GCSLAB_CHECK(polynomial.total_degree() <= 3);
  const auto r = static_cast<std::uint32_t>(row);
  for (const auto& [exponents, rational] : polynomial.terms()) {
    const double coefficient = nearest_double(rational);
    std::vector<std::uint32_t> factors;
    for (std::size_t i = 0; i < exponents.size(); ++i) {
      for (int k = 0; k < exponents[i]; ++k) factors.push_back(static_cast<std::uint32_t>(variables[i]));
    }
    if (factors.empty()) constants_.push_back({r, coefficient});
    if (factors.size() == 1) linear_.push_back({r, factors[0], coefficient});
    if (factors.size() == 2) products_.push_back({r, factors[0], factors[1], coefficient});
    if (factors.size() == 3) cubics_.push_back({r, factors[0], factors[1], factors[2], coefficient});
  }
}

void CubicForms::scale(std::size_t row, double factor) {
  for (Cubic& cubic : cubics_) {
    if (cubic.row == row) cubic.coefficient *= factor;
  }
  for (Product& product : products_) {
    if (product.row == row) product.coefficient *= factor;
  }
  for (Linear& term : linear_) {
    if (term.row == row) term.coefficient *= factor;
  }
  for (Constant& constant : constants_) {
    if (constant.row == row) constant.value *= factor;
  }
}

void CubicForms::add_values(std::span<const double> x, std::span<double> result) const {
  for (const auto& [row, value] : constants_) result[row] += value;
  for (const auto& [row, i, coefficient] : linear_) result[row] += coefficient * x[i];
  for (const auto& [row, i, j, coefficient] : products_) result[row] += coefficient * x[i] * x[j];
  for (const auto& [row, i, j, k, coefficient] : cubics_) result[row] += coefficient * x[i] * x[j] * x[k];
}

void CubicForms::add_derivatives(std::span<const double> x, std::span<const double> speed,
                                 std::span<const std::size_t> column, std::span<double> result,
                                 Matrix<double>& derivatives) const {
  for (const auto& [row, value] : constants_) result[row] += value;
  for (const auto& [row, i, coefficient] : linear_) {
    result[row] += coefficient * x[i];
    derivatives(row, column[i]) += coefficient * speed[i];
  }
  for (const auto& [row, i, j, coefficient] : products_) {
    const double left = coefficient * x[i], right = coefficient * x[j];
    result[row] += left * x[j];
    derivatives(row, column[i]) += right * speed[i];
    derivatives(row, column[j]) += left * speed[j];
  }
  for (const auto& [row, i, j, k, coefficient] : cubics_) {
    const double left = coefficient * x[i], both = left * x[j];
    result[row] += both * x[k];
    derivatives(row, column[i]) += coefficient * x[j] * x[k] * speed[i];
    derivatives(row, column[j]) += left * x[k] * speed[j];
    derivatives(row, column[k]) += both * speed[k];
  }
}

}  // namespace gcslab
