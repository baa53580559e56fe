#include "polynomial/power.h"

#include <algorithm>
#include <type_traits>

#include "base/check.h"
#include "interval/arithmetic.h"
#include "interval/point_numbers.h"
#include "polynomial/upward_kernels.h"

namespace gcslab {
namespace {

template <class T>
T number(const Rational& value) {
  return NumberTraits<T>::from_rational(value);
}

/// Row k of each block times 2^-k.
template <class T>
void scale_rows(const AxisShape& shape, const T* source, T* result) {
  Rational scale = 1;
  for (std::size_t k = 0; k < shape.count; ++k, scale /= 2) {
    const T factor = number<T>(scale);
    for (std::size_t b = 0; b < shape.blocks; ++b) {
      const std::size_t row = (b * shape.count + k) * shape.row;
      for (std::size_t i = row; i < row + shape.row; ++i) result[i] = source[i] * factor;
    }
  }
}

template <class T>
void negate_odd_rows(const AxisShape& shape, T* values) {
  for (std::size_t b = 0; b < shape.blocks; ++b) {
    for (std::size_t k = 1; k < shape.count; k += 2) {
      T* row = values + (b * shape.count + k) * shape.row;
      std::transform(row, row + shape.row, row, [](const T& x) -> T { return -x; });
    }
  }
}

/// Coefficients c_k to those of sum c_k (w + 1)^k, along one variable.
template <class T>
void shift_by_one(const AxisShape& shape, T* values) {
  for (std::size_t b = 0; b < shape.blocks; ++b) {
    T* block = values + b * shape.count * shape.row;
    for (std::size_t level = 0; level + 1 < shape.count; ++level) {
      for (std::size_t i = (shape.count - 1) * shape.row; i-- > level * shape.row;) {
        block[i] = block[i] + block[i + shape.row];
      }
    }
  }
}

/// [-1, 1] or, for even monomials of the even variant, [0, 1] times each coefficient but the constant one,
/// summed.
template <class T>
T sum_of_ranges(const PowerTensor<T>& tensor, TaubinVariant variant) {
  const T symmetric = NumberTraits<T>::from_interval({-1, 1});
  const T positive = NumberTraits<T>::from_interval({0, 1});
  T result = number<T>(0);
  Exponents index(tensor.degrees().size(), 0);
  for (std::size_t i = 1; i < tensor.coefficients().size(); ++i) {
    next_index(index, tensor.degrees());
    const bool even =
        variant == TaubinVariant::even && std::ranges::all_of(index, [](int k) { return k % 2 == 0; });
    result = result + tensor.coefficients()[i] * (even ? positive : symmetric);
  }
  return result;
}

/// The sum over one row, of which the first coefficient is the constant one when `has_constant`.
FastInterval row_sum(const FastInterval* row, std::size_t count, bool even, bool has_constant) {
  if (!has_constant) return even ? alternating_sum_upward(row, count) : symmetric_sum_upward(row, count);
  if (count == 1) return FastInterval(0.0);
  if (!even) return symmetric_sum_upward(row + 1, count - 1);
  return symmetric_sum_upward(row + 1, 1) + alternating_sum_upward(row + 2, count - 2);
}

/// The rows along the last variable alternate between even and other monomials, or have no even one.
FastInterval sum_of_ranges(const PowerTensor<FastInterval>& tensor, TaubinVariant variant) {
  const FastInterval* values = tensor.coefficients().data();
  if (variant == TaubinVariant::plain || tensor.variables() == 0) {
    return row_sum(values, tensor.coefficients().size(), false, true);
  }
  Exponents outer(tensor.degrees().begin(), tensor.degrees().end() - 1);
  Exponents index(outer.size(), 0);
  const auto count = static_cast<std::size_t>(tensor.degrees().back()) + 1;
  FastInterval result(0.0);
  for (std::size_t row = 0; row < tensor.coefficients().size(); row += count, next_index(index, outer)) {
    const bool even = std::ranges::all_of(index, [](int k) { return k % 2 == 0; });
    result = result + row_sum(values + row, count, even, row == 0);
  }
  return result;
}

}  // namespace

template <class T>
void PowerTensor<T>::halve(int variable, PowerTensor& left, PowerTensor& right) const {
  GCSLAB_CHECK(&left != &right);
  left.resize_like(*this);
  right.resize_like(*this);
  const AxisShape shape = this->shape(variable);
  const T* source = this->coefficients_.data();
  T* lower = left.coefficients_.data();
  T* upper = right.coefficients_.data();
  if constexpr (std::is_same_v<T, FastInterval>) {
    if (halve_power_upward(source, lower, upper, shape)) return;
  }
  scale_rows(shape, source, upper);
  std::copy_n(upper, this->coefficients_.size(), lower);
  negate_odd_rows(shape, lower);
  shift_by_one(shape, lower);
  negate_odd_rows(shape, lower);
  shift_by_one(shape, upper);
}

template <class T>
T PowerTensor<T>::evaluate(const std::vector<Rational>& point) const {
  GCSLAB_CHECK(point.size() == this->degrees_.size());
  std::vector<T> values = this->coefficients_;
  for (int variable = this->variables(); variable-- > 0;) {
    const T x = number<T>(point[static_cast<std::size_t>(variable)]);
    const auto count = static_cast<std::size_t>(this->degree(variable)) + 1;
    const std::size_t fibres = values.size() / count;
    for (std::size_t fibre = 0; fibre < fibres; ++fibre) {
      T value = values[fibre * count + count - 1];
      for (std::size_t k = count - 1; k-- > 0;) value = T(value * x) + values[fibre * count + k];
      values[fibre] = value;
    }
    values.resize(fibres);
  }
  return values.front();
}

template <class T>
PowerTensor<T> power_from_polynomial(const Polynomial& polynomial, const RationalBox& box) {
  const Tensor<Rational> exact = exact_power_coefficients(polynomial, box);
  std::vector<T> coefficients;
  coefficients.reserve(exact.coefficients().size());
  for (const Rational& value : exact.coefficients()) coefficients.push_back(number<T>(value));
  return {exact.degrees(), std::move(coefficients)};
}

template <class T>
Interval taubin_range(const PowerTensor<T>& tensor, TaubinVariant variant) {
  return NumberTraits<T>::enclosure(tensor.coefficients().front() + sum_of_ranges(tensor, variant));
}

#define GCSLAB_INSTANTIATE(T)    \
  template class PowerTensor<T>; \
  template PowerTensor<T> power_from_polynomial<T>(const Polynomial&, const RationalBox&)

GCSLAB_INSTANTIATE(double);
GCSLAB_INSTANTIATE(Rational);
GCSLAB_INSTANTIATE(FastInterval);
GCSLAB_INSTANTIATE(BoostInterval);
GCSLAB_INSTANTIATE(MpfrInterval);
GCSLAB_INSTANTIATE(UnroundedInterval);

#undef GCSLAB_INSTANTIATE

template Interval taubin_range(const PowerTensor<FastInterval>&, TaubinVariant);
template Interval taubin_range(const PowerTensor<BoostInterval>&, TaubinVariant);
template Interval taubin_range(const PowerTensor<MpfrInterval>&, TaubinVariant);
template Interval taubin_range(const PowerTensor<UnroundedInterval>&, TaubinVariant);

}  // namespace gcslab
