#include "homotopy/cubic_forms.h"

#include <algorithm>

#include "base/check.h"
#include "interval/rational.h"

namespace gcslab {

void CubicForms::Sums::add(double coefficient, std::span<const std::uint32_t> factors) {
  if (factors.empty()) constant_ += coefficient;
  if (factors.size() == 1) linear_.push_back({factors[0], coefficient});
  if (factors.size() == 2) products_.push_back({factors[0], factors[1], coefficient});
  if (factors.size() == 3) cubics_.push_back({factors[0], factors[1], factors[2], coefficient});
}

void CubicForms::Sums::scale(std::size_t sum, double factor) {
  const End start = sum == 0 ? End{} : ends_[sum - 1];
  End& end = ends_[sum];
  end.constant *= factor;
  for (std::size_t k = start.linear; k < end.linear; ++k) linear_[k].coefficient *= factor;
  for (std::size_t k = start.products; k < end.products; ++k) products_[k].coefficient *= factor;
  for (std::size_t k = start.cubics; k < end.cubics; ++k) cubics_[k].coefficient *= factor;
}

template <class Take>
void CubicForms::Sums::evaluate(std::span<const double> x, const Take& take) const {
  const double* const at = x.data();
  const Linear* linear = linear_.data();
  const Product* product = products_.data();
  const Cubic* cubic = cubics_.data();
  for (std::size_t number = 0; number < ends_.size(); ++number) {
    const End& end = ends_[number];
    double sum = end.constant;
    for (const Linear* const last = linear_.data() + end.linear; linear != last; ++linear)
      sum += linear->coefficient * at[linear->i];
    for (const Product* const last = products_.data() + end.products; product != last; ++product)
      sum += product->coefficient * at[product->i] * at[product->j];
    for (const Cubic* const last = cubics_.data() + end.cubics; cubic != last; ++cubic)
      sum += cubic->coefficient * at[cubic->i] * at[cubic->j] * at[cubic->k];
    take(number, sum);
  }
}

void CubicForms::add(std::size_t row, const Polynomial& polynomial, std::span<const std::size_t> variables) {
  GCSLAB_CHECK(polynomial.total_degree() <= 3);
  std::vector<std::uint32_t> factors;
  const auto set_factors = [&](const auto& exponents) {
    factors.clear();
    for (std::size_t i = 0; i < exponents.size(); ++i) {
      for (int k = 0; k < exponents[i]; ++k) factors.push_back(static_cast<std::uint32_t>(variables[i]));
    }
  };
  for (const auto& [exponents, rational] : polynomial.terms()) {
    set_factors(exponents);
    forms_.add(nearest_double(rational), factors);
  }
  forms_.finish();
  rows_.push_back(row);
  for (std::size_t i = 0; i < variables.size(); ++i) {
    for (const auto& [exponents, rational] : polynomial.terms()) {
      if (exponents[i] == 0) continue;
      set_factors(exponents);
      factors.erase(std::ranges::find(factors, static_cast<std::uint32_t>(variables[i])));
      slopes_.add(exponents[i] * nearest_double(rational), factors);
    }
    slopes_.finish();
    derivatives_.push_back({row, variables[i]});
  }
}

void CubicForms::scale(std::size_t row, double factor) {
  for (std::size_t k = 0; k < rows_.size(); ++k) {
    if (rows_[k] == row) forms_.scale(k, factor);
  }
  for (std::size_t k = 0; k < derivatives_.size(); ++k) {
    if (derivatives_[k].row == row) slopes_.scale(k, factor);
  }
}

void CubicForms::values(std::span<const double> x, std::span<double> result) const {
  forms_.evaluate(x, [&](std::size_t k, double value) { result[rows_[k]] = value; });
}

void CubicForms::add_derivatives(std::span<const double> x, std::span<const double> speed,
                                 std::span<const std::size_t> column, Matrix<double>& derivatives) const {
  slopes_.evaluate(x, [&](std::size_t k, double slope) {
    const auto [row, variable] = derivatives_[k];
    derivatives(row, column[variable]) += speed[variable] * slope;
  });
}

}  // namespace gcslab
