#include "linear_program/edge_matrix.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <immintrin.h>

namespace gcslab {
namespace {

constexpr std::size_t kBlock = 4;
constexpr double kNoise = 1e-13;
/// Cancellation must not make an edge look shorter than any is.
constexpr double kSmallestSquaredLength = 1e-8;

__m256d without_noise(__m256d x) {
  const __m256d magnitude = _mm256_andnot_pd(_mm256_set1_pd(-0.0), x);
  return _mm256_and_pd(x, _mm256_cmp_pd(magnitude, _mm256_set1_pd(kNoise), _CMP_GT_OQ));
}

double sum_of(__m256d x) {
  const __m128d pair = _mm_add_pd(_mm256_castpd256_pd128(x), _mm256_extractf128_pd(x, 1));
  return _mm_cvtsd_f64(_mm_add_sd(pair, _mm_unpackhi_pd(pair, pair)));
}

}  // namespace

void EdgeMatrix::reset(std::size_t size) {
  size_ = size;
  stride_ = (size + kBlock - 1) / kBlock * kBlock;
  entries_.assign(size_ * stride_, 0.0);
  for (std::size_t j = 0; j < size_; ++j) entries_[j * stride_ + j] = 1;
  squared_lengths_.assign(stride_, 1.0);
  factors_.assign(stride_, 0.0);
  inner_.assign(stride_, 0.0);
  moving_.assign(size_, 0);
}

void EdgeMatrix::copy_edge(std::size_t slot, double* edge) const {
  const double* entry = entries_.data() + slot;
  for (std::size_t j = 0; j < size_; ++j, entry += stride_) edge[j] = std::abs(*entry) > kNoise ? *entry : 0;
}

void EdgeMatrix::along_edges(std::span<const int> columns, std::span<const double> values,
                             double* result) const {
  std::fill_n(result, stride_, 0.0);
  for (std::size_t k = 0; k < columns.size(); ++k) {
    const double* row = coordinate(static_cast<std::size_t>(columns[k]));
    const __m256d value = _mm256_set1_pd(values[k]);
    for (std::size_t t = 0; t < stride_; t += kBlock) {
      _mm256_storeu_pd(result + t,
                       _mm256_fmadd_pd(value, _mm256_loadu_pd(row + t), _mm256_loadu_pd(result + t)));
    }
  }
}

void EdgeMatrix::vertex(const double* offset, double* point) const {
  for (std::size_t j = 0; j < size_; ++j) {
    __m256d total = _mm256_setzero_pd();
    for (std::size_t t = 0; t < stride_; t += kBlock) {
      total = _mm256_fmadd_pd(_mm256_loadu_pd(offset + t), _mm256_loadu_pd(coordinate(j) + t), total);
    }
    point[j] = sum_of(total);
  }
}

/// edge_t -= step * factor_t in a few coordinates at a time, and their old values into the inner products.
template <std::size_t count>
void EdgeMatrix::update_coordinates(const std::size_t* coordinates, const double* edge) {
  std::array<double*, count> rows;
  __m256d steps[count];
  for (std::size_t i = 0; i < count; ++i) {
    rows[i] = entries_.data() + coordinates[i] * stride_;
    steps[i] = _mm256_set1_pd(edge[coordinates[i]]);
  }
  const double* factors = factors_.data();
  double* inner = inner_.data();
  for (const std::size_t t : blocks_) {
    const __m256d factor = _mm256_loadu_pd(factors + t);
    __m256d product = _mm256_loadu_pd(inner + t);
    for (std::size_t i = 0; i < count; ++i) {
      const __m256d old = _mm256_loadu_pd(rows[i] + t);
      product = _mm256_fmadd_pd(steps[i], old, product);
      _mm256_storeu_pd(rows[i] + t, _mm256_fnmadd_pd(steps[i], factor, old));
    }
    _mm256_storeu_pd(inner + t, product);
  }
}

void EdgeMatrix::find_factors(const double* along, double inverse) {
  blocks_.clear();
  for (std::size_t t = 0; t < stride_; t += kBlock) {
    const __m256d factors = without_noise(_mm256_mul_pd(_mm256_loadu_pd(along + t), _mm256_set1_pd(inverse)));
    _mm256_storeu_pd(factors_.data() + t, factors);
    _mm256_storeu_pd(inner_.data() + t, _mm256_setzero_pd());
    const int is_zero = _mm256_movemask_pd(_mm256_cmp_pd(factors, _mm256_setzero_pd(), _CMP_EQ_OQ));
    if (is_zero != 15) blocks_.push_back(t);
  }
}

/// Without a branch, which could not be foretold.
std::size_t EdgeMatrix::find_moving(const double* edge) {
  std::size_t count = 0;
  for (std::size_t j = 0; j < size_; ++j) {
    moving_[count] = j;
    count += edge[j] != 0 ? 1U : 0U;
  }
  return count;
}

void EdgeMatrix::exchange(std::size_t slot, const double* along, const double* edge) {
  const double inverse = 1 / along[slot];
  find_factors(along, inverse);
  const std::size_t count = find_moving(edge);
  std::size_t k = 0;
  for (; k + 8 <= count; k += 8) update_coordinates<8>(moving_.data() + k, edge);
  for (; k + 4 <= count; k += 4) update_coordinates<4>(moving_.data() + k, edge);
  for (; k < count; ++k) update_coordinates<1>(moving_.data() + k, edge);
  for (k = 0; k < count; ++k) entries_[moving_[k] * stride_ + slot] = edge[moving_[k]] * inverse;
  update_squared_lengths(slot, inverse);
}

/// |edge_t - f edge_s|^2 = |edge_t|^2 - 2 f edge_t.edge_s + f^2 |edge_s|^2.
void EdgeMatrix::update_squared_lengths(std::size_t slot, double inverse) {
  const double squared_length = squared_lengths_[slot];
  for (const std::size_t block : blocks_) {
    for (std::size_t t = block; t < block + kBlock; ++t) {
      const double change = factors_[t] * (2 * inner_[t] - factors_[t] * squared_length);
      squared_lengths_[t] = std::max(squared_lengths_[t] - change, kSmallestSquaredLength);
    }
  }
  squared_lengths_[slot] = std::max(squared_length * inverse * inverse, kSmallestSquaredLength);
}

}  // namespace gcslab
