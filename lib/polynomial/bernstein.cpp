#include "polynomial/bernstein.h"

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

/// One step of de Casteljau: rows k of a block become (1 - t) row_k + t row_(k+1), for the first `sums` rows.
template <class T>
struct CasteljauStep {
  T low_weight;
  T high_weight;
  explicit CasteljauStep(const Rational& t) : low_weight(number<T>(1 - t)), high_weight(number<T>(t)) {}
  void operator()(T* block, std::size_t row, std::size_t sums) const {
    for (std::size_t i = 0; i < sums * row; ++i) {
      block[i] = low_weight * block[i] + high_weight * block[i + row];
    }
  }
};

/// The same at 1/2 with one product a sum.
template <class T>
struct HalvingStep {
  T half = number<T>(Rational(1, 2));
  void operator()(T* block, std::size_t row, std::size_t sums) const {
    for (std::size_t i = 0; i < sums * row; ++i) block[i] = half * T(block[i] + block[i + row]);
  }
};

/// `right` holds the coefficients; afterwards it holds those of the right part, `left` those of the left
/// part.
template <class T, class Step>
void subdivide(const AxisShape& shape, T* left, T* right, const Step& step) {
  const std::size_t block = shape.count * shape.row;
  for (std::size_t b = 0; b < shape.blocks; ++b) {
    for (std::size_t level = 0; level < shape.count; ++level) {
      if (level > 0) step(right + b * block, shape.row, shape.count - level);
      std::copy_n(right + b * block, shape.row, left + b * block + level * shape.row);
    }
  }
}

/// A matrix applied along one variable: result row i is the sum of matrix(i, k) times row k.
template <class T>
Tensor<T> along(const Tensor<T>& tensor, int variable, std::size_t count,
                const std::vector<std::vector<T>>& matrix) {
  const AxisShape shape = tensor.shape(variable);
  Exponents degrees = tensor.degrees();
  degrees[static_cast<std::size_t>(variable)] = static_cast<int>(count) - 1;
  std::vector<T> result(shape.blocks * count * shape.row, number<T>(0));
  for (std::size_t b = 0; b < shape.blocks; ++b) {
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t k = 0; k < matrix[i].size(); ++k) {
        const T* from = &tensor.coefficients()[(b * shape.count + k) * shape.row];
        T* to = &result[(b * count + i) * shape.row];
        for (std::size_t j = 0; j < shape.row; ++j) to[j] = to[j] + T(matrix[i][k] * from[j]);
      }
    }
  }
  return {std::move(degrees), std::move(result)};
}

Rational binomial(int n, int k) {
  mpz_class result;
  mpz_bin_uiui(result.get_mpz_t(), static_cast<unsigned long>(n), static_cast<unsigned long>(k));
  return result;
}

/// Degree raised by one: b'_i = i/(d+1) b_(i-1) + (1 - i/(d+1)) b_i.
template <class T>
std::vector<std::vector<T>> elevation_matrix(int degree) {
  const auto count = static_cast<std::size_t>(degree) + 2;
  std::vector<std::vector<T>> matrix(count, std::vector<T>(count - 1, number<T>(0)));
  for (int i = 0; i <= degree + 1; ++i) {
    const Rational weight = Rational(i) / (degree + 1);
    auto& row = matrix[static_cast<std::size_t>(i)];
    if (i > 0) row[static_cast<std::size_t>(i - 1)] = number<T>(weight);
    if (i <= degree) row[static_cast<std::size_t>(i)] = number<T>(1 - weight);
  }
  return matrix;
}

template <class T, class Values>
Interval hull_of(const Values& values) {
  Interval result;
  for (const T& value : values) result = hull(result, NumberTraits<T>::enclosure(value));
  return result;
}

}  // namespace

template <class T>
void BernsteinTensor<T>::halve(int variable, BernsteinTensor& left, BernsteinTensor& right) const {
  GCSLAB_CHECK(&left != &right);
  left.resize_like(*this);
  right.resize_like(*this);
  const AxisShape shape = this->shape(variable);
  if constexpr (std::is_same_v<T, FastInterval>) {
    halve_bernstein_upward(this->coefficients_.data(), left.coefficients_.data(), right.coefficients_.data(),
                           shape);
  } else {
    if (&right != this)
      std::copy(this->coefficients_.begin(), this->coefficients_.end(), right.coefficients_.begin());
    subdivide(shape, left.coefficients_.data(), right.coefficients_.data(), HalvingStep<T>{});
  }
}

template <class T>
std::pair<BernsteinTensor<T>, BernsteinTensor<T>> BernsteinTensor<T>::split(int variable,
                                                                            const Rational& t) const {
  std::pair<BernsteinTensor, BernsteinTensor> parts{*this, *this};
  subdivide(this->shape(variable), parts.first.coefficients_.data(), parts.second.coefficients_.data(),
            CasteljauStep<T>(t));
  return parts;
}

template <class T>
BernsteinTensor<T> BernsteinTensor<T>::elevated(int variable, int by) const {
  BernsteinTensor result = *this;
  for (int step = 0; step < by; ++step) {
    const int degree = result.degree(variable);
    const auto count = static_cast<std::size_t>(degree) + 2;
    result = BernsteinTensor(along<T>(result, variable, count, elevation_matrix<T>(degree)));
  }
  return result;
}

template <class T>
BernsteinTensor<T> BernsteinTensor<T>::derivative(int variable) const {
  const AxisShape shape = this->shape(variable);
  const std::size_t count = std::max<std::size_t>(shape.count, 2) - 1;
  Exponents degrees = this->degrees_;
  degrees[static_cast<std::size_t>(variable)] = static_cast<int>(count) - 1;
  std::vector<T> result(shape.blocks * count * shape.row, number<T>(0));
  if (shape.count == 1) return {std::move(degrees), std::move(result)};
  const T degree = number<T>(Rational(this->degree(variable)));
  for (std::size_t b = 0; b < shape.blocks; ++b) {
    const T* from = &this->coefficients_[b * shape.count * shape.row];
    T* to = &result[b * count * shape.row];
    for (std::size_t i = 0; i < count * shape.row; ++i) to[i] = degree * T(from[i + shape.row] - from[i]);
  }
  return {std::move(degrees), std::move(result)};
}

template <class T>
BernsteinTensor<T> BernsteinTensor<T>::face(int variable, Side side) const {
  const AxisShape shape = this->shape(variable);
  const std::size_t row = side == Side::lower ? 0 : shape.count - 1;
  Exponents degrees = this->degrees_;
  degrees.erase(degrees.begin() + variable);
  std::vector<T> result;
  result.reserve(shape.blocks * shape.row);
  for (std::size_t b = 0; b < shape.blocks; ++b) {
    const T* from = &this->coefficients_[(b * shape.count + row) * shape.row];
    result.insert(result.end(), from, from + shape.row);
  }
  return {std::move(degrees), std::move(result)};
}

template <class T>
T BernsteinTensor<T>::evaluate(const std::vector<Rational>& point) const {
  GCSLAB_CHECK(point.size() == this->degrees_.size());
  std::vector<T> values = this->coefficients_;
  for (int variable = this->variables(); variable-- > 0;) {
    const CasteljauStep<T> step(point[static_cast<std::size_t>(variable)]);
    const auto count = static_cast<std::size_t>(this->degree(variable)) + 1;
    const std::size_t fibres = values.size() / count;
    for (std::size_t fibre = 0; fibre < fibres; ++fibre) {
      for (std::size_t sums = count; sums-- > 1;) step(&values[fibre * count], 1, sums);
      values[fibre] = values[fibre * count];
    }
    values.resize(fibres);
  }
  return values.front();
}

template <class T>
const T& BernsteinTensor<T>::corner(std::size_t corner) const {
  std::size_t place = 0;
  for (std::size_t i = 0; i < this->degrees_.size(); ++i) {
    const auto last = static_cast<std::size_t>(this->degrees_[i]);
    place = place * (last + 1) + (((corner >> i) & 1U) == 0 ? 0 : last);
  }
  return this->coefficients_[place];
}

template <class T>
Interval BernsteinTensor<T>::range() const {
  if constexpr (std::is_same_v<T, FastInterval>) {
    return hull_upward(this->coefficients_.data(), this->coefficients_.size()).interval();
  } else {
    return hull_of<T>(this->coefficients_);
  }
}

template <class T>
Interval BernsteinTensor<T>::corner_hull() const {
  Interval result;
  for (std::size_t i = 0; i < std::size_t{1} << this->degrees_.size(); ++i) {
    result = hull(result, NumberTraits<T>::enclosure(corner(i)));
  }
  return result;
}

template <class T>
bool BernsteinTensor<T>::sharp() const {
  return range() == corner_hull();
}

template <class T>
BernsteinTensor<T> bernstein_from_polynomial(const Polynomial& polynomial, const RationalBox& box,
                                             const Exponents& degrees) {
  const Tensor<Rational> exact = exact_bernstein_coefficients(polynomial, box, degrees);
  std::vector<T> coefficients;
  coefficients.reserve(exact.coefficients().size());
  for (const Rational& value : exact.coefficients()) coefficients.push_back(number<T>(value));
  return {exact.degrees(), std::move(coefficients)};
}

template <class T>
BernsteinConverter<T>::BernsteinConverter(std::span<const Polynomial> polynomials, const Exponents& degrees)
    : degrees_(degrees) {
  for (const Polynomial& polynomial : polynomials) {
    Tensor<T> tensor(degrees, std::vector<T>(coefficient_count(degrees), number<T>(0)));
    for (const auto& [exponents, coefficient] : polynomial.terms()) {
      std::size_t place = 0;
      for (std::size_t i = 0; i < degrees.size(); ++i)
        place = place * static_cast<std::size_t>(degrees[i] + 1) + static_cast<std::size_t>(exponents[i]);
      tensor.coefficients()[place] = number<T>(coefficient);
    }
    power_tensors_.push_back(std::move(tensor));
  }
  for (const int degree : degrees) {
    factors_.emplace_back();
    for (int i = 0; i <= degree; ++i) {
      for (int k = 0; k <= degree; ++k) {
        for (int j = 0; j <= std::min(i, k); ++j)
          factors_.back().push_back(number<T>(binomial(k, j) * binomial(i, j) / binomial(degree, j)));
      }
    }
  }
}

/// The weights W_ik of the coefficient of x^k in Bernstein coefficient i of degree d on [u, u + w]:
///   W_ik = sum_{j <= min(i, k)} binomial(k, j) binomial(i, j) / binomial(d, j) w^j u^(k-j).
template <class T>
std::vector<std::vector<T>> BernsteinConverter<T>::matrix(std::size_t variable, const T& start,
                                                          const T& width) const {
  const auto count = static_cast<std::size_t>(degrees_[variable]) + 1;
  std::vector<T> powers_of_start(count, number<T>(1));
  std::vector<T> powers_of_width(count, number<T>(1));
  for (std::size_t k = 1; k < count; ++k) {
    powers_of_start[k] = powers_of_start[k - 1] * start;
    powers_of_width[k] = powers_of_width[k - 1] * width;
  }
  std::vector<std::vector<T>> result(count, std::vector<T>(count, number<T>(0)));
  auto factor = factors_[variable].begin();
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t k = 0; k < count; ++k) {
      for (std::size_t j = 0; j <= std::min(i, k); ++j) {
        const T powers = powers_of_width[j] * powers_of_start[k - j];
        result[i][k] = result[i][k] + T(*factor++ * powers);
      }
    }
  }
  return result;
}

template <class T>
std::vector<BernsteinTensor<T>> BernsteinConverter<T>::convert(std::span<const T> starts,
                                                               std::span<const T> widths) const {
  std::vector<Tensor<T>> tensors = power_tensors_;
  for (std::size_t i = 0; i < degrees_.size(); ++i) {
    const auto count = static_cast<std::size_t>(degrees_[i]) + 1;
    const std::vector<std::vector<T>> weights = matrix(i, starts[i], widths[i]);
    for (Tensor<T>& tensor : tensors) tensor = along(tensor, static_cast<int>(i), count, weights);
  }
  std::vector<BernsteinTensor<T>> result;
  for (Tensor<T>& tensor : tensors) result.emplace_back(std::move(tensor));
  return result;
}

template <class T>
BernsteinTensor<T> bernstein_computed_in(const Polynomial& polynomial, const RationalBox& box,
                                         const Exponents& degrees) {
  const BernsteinConverter<T> converter({&polynomial, 1}, degrees.empty() ? polynomial.degrees() : degrees);
  std::vector<T> starts, widths;
  for (const RationalInterval& side : box) {
    starts.push_back(number<T>(side.lower));
    widths.push_back(number<T>(side.upper - side.lower));
  }
  return converter.convert(starts, widths).front();
}

template <class T>
std::pair<T, T> extreme_coefficients(const BernsteinTensor<T>& tensor) {
  const auto [least, largest] = std::ranges::minmax_element(tensor.coefficients());
  return {*least, *largest};
}

template std::pair<float, float> extreme_coefficients(const BernsteinTensor<float>&);
template std::pair<double, double> extreme_coefficients(const BernsteinTensor<double>&);
template std::pair<Rational, Rational> extreme_coefficients(const BernsteinTensor<Rational>&);

#define GCSLAB_INSTANTIATE(T)                                                                     \
  template class BernsteinTensor<T>;                                                              \
  template class BernsteinConverter<T>;                                                           \
  template BernsteinTensor<T> bernstein_from_polynomial<T>(const Polynomial&, const RationalBox&, \
                                                           const Exponents&);                     \
  template BernsteinTensor<T> bernstein_computed_in<T>(const Polynomial&, const RationalBox&,     \
                                                       const Exponents&)

GCSLAB_INSTANTIATE(float);
GCSLAB_INSTANTIATE(double);
GCSLAB_INSTANTIATE(Rational);
GCSLAB_INSTANTIATE(FastInterval);
GCSLAB_INSTANTIATE(BoostInterval);
GCSLAB_INSTANTIATE(MpfrInterval);
GCSLAB_INSTANTIATE(UnroundedInterval);

#undef GCSLAB_INSTANTIATE

}  // namespace gcslab
