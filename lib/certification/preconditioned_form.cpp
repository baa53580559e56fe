#include "certification/preconditioned_form.h"

#include <algorithm>
#include <cmath>

#include "certification/newton_iteration.h"
#include "interval/arithmetic.h"
#include "interval/scaled.h"

namespace gcslab {
namespace {

template <class T>
T number(double value) {
  return NumberTraits<T>::from_interval(Interval(value));
}

}  // namespace

template <class T>
PreconditionedForm<T>::PreconditionedForm(const SystemFunctions& functions)
    : evaluator_(functions),
      zero_(number<T>(0)),
      slopes_(functions.equations().size(), functions.variables(), zero_),
      matrix_(slopes_),
      function_values_(functions.equations().size(), zero_),
      values_(function_values_) {}

template <class T>
bool PreconditionedForm<T>::evaluate(const Box& box, std::span<const double> centre) {
  box_.clear();
  centre_.clear();
  offsets_.clear();
  for (std::size_t i = 0; i < box.size(); ++i) {
    box_.push_back(NumberTraits<T>::from_interval(box[i]));
    centre_.push_back(number<T>(centre[i]));
    offsets_.push_back(box_[i] - centre_[i]);
  }
  if (!evaluator_.jacobian(box_, slopes_)) return false;
  evaluator_.values(centre_, function_values_);
  return true;
}

template <class T>
std::optional<Matrix<double>> PreconditionedForm<T>::midpoint_inverse() const {
  Matrix<double> middle(slopes_.rows(), slopes_.columns());
  for (std::size_t i = 0; i < slopes_.rows(); ++i) {
    for (std::size_t j = 0; j < slopes_.columns(); ++j)
      middle(i, j) = midpoint(NumberTraits<T>::enclosure(slopes_(i, j)));
  }
  return approximate_inverse(middle);
}

template <class T>
void PreconditionedForm<T>::precondition(const Matrix<double>& multipliers) {
  combine_rows<T>(multipliers, slopes_, matrix_);
  for (std::size_t i = 0; i < values_.size(); ++i)
    values_[i] = combination<T>(multipliers.row(i), function_values_);
}

template <class T>
T combination(std::span<const double> multipliers, std::span<const T> values) {
  T sum = number<T>(0);
  for (std::size_t k = 0; k < values.size(); ++k) {
    if (multipliers[k] != 0) sum = sum + scaled(multipliers[k], values[k]);
  }
  return sum;
}

template <class T>
void combine_rows(const Matrix<double>& multipliers, const Matrix<T>& slopes, Matrix<T>& product) {
  product.fill(number<T>(0));
  for (std::size_t i = 0; i < multipliers.rows(); ++i) {
    for (std::size_t k = 0; k < multipliers.columns(); ++k) {
      const double multiplier = multipliers(i, k);
      if (multiplier == 0) continue;
      for (std::size_t j = 0; j < slopes.columns(); ++j)
        product(i, j) = product(i, j) + scaled(multiplier, slopes(k, j));
    }
  }
}

bool is_proved_nonsingular(const Matrix<double>& matrix) {
  const std::optional<Matrix<double>> inverse = approximate_inverse(matrix);
  if (!inverse) return false;
  const NumberTraits<FastInterval>::Scope scope;
  const std::size_t n = matrix.rows();
  for (std::size_t i = 0; i < n; ++i) {
    FastInterval norm(0.0);
    for (std::size_t j = 0; j < n; ++j) {
      FastInterval entry(i == j ? 1.0 : 0.0);
      for (std::size_t k = 0; k < n; ++k)
        entry = entry - FastInterval(matrix(i, k)) * FastInterval((*inverse)(k, j));
      norm = norm + abs(entry);
    }
    if (!(norm.upper() < 1)) return false;
  }
  return true;
}

#define GCSLAB_INSTANTIATE(T)                                             \
  template class PreconditionedForm<T>;                                   \
  template T combination<T>(std::span<const double>, std::span<const T>); \
  template void combine_rows<T>(const Matrix<double>&, const Matrix<T>&, Matrix<T>&)

GCSLAB_INSTANTIATE(FastInterval);
GCSLAB_INSTANTIATE(BoostInterval);
GCSLAB_INSTANTIATE(MpfrInterval);
GCSLAB_INSTANTIATE(UnroundedInterval);

#undef GCSLAB_INSTANTIATE

}  // namespace gcslab
