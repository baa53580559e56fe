#pragma once

// Columns of a tensor of FastIntervals, two intervals side by side in one vector. Private to the kernels.
//
// A column is one place in a row together with the same place in every row of its block. Two neighbouring
// columns fill a vector of four doubles. When a row has an odd number of intervals, its last column shares a
// vector with that of the next block, and the very last one goes alone.

#include <bit>
#include <cstddef>
#include <cstdint>
#include <immintrin.h>
#include <utility>

#include "polynomial/tensor.h"

namespace gcslab::kernel_detail {

/// Four consecutive doubles.
struct NeighbourLanes {
  using Vector = __m256d;
  Vector load(const double* place) const { return _mm256_loadu_pd(place); }
  void store(double* place, Vector x) const { _mm256_storeu_pd(place, x); }
  static Vector broadcast(double x) { return _mm256_set1_pd(x); }
};

/// Two doubles here and two doubles `distance` further on.
struct DistantLanes {
  using Vector = __m256d;
  std::size_t distance;
  Vector load(const double* place) const {
    return _mm256_insertf128_pd(_mm256_castpd128_pd256(_mm_loadu_pd(place)), _mm_loadu_pd(place + distance),
                                1);
  }
  void store(double* place, Vector x) const {
    _mm_storeu_pd(place, _mm256_castpd256_pd128(x));
    _mm_storeu_pd(place + distance, _mm256_extractf128_pd(x, 1));
  }
  static Vector broadcast(double x) { return _mm256_set1_pd(x); }
};

/// Two doubles.
struct SingleLanes {
  using Vector = __m128d;
  Vector load(const double* place) const { return _mm_loadu_pd(place); }
  void store(double* place, Vector x) const { _mm_storeu_pd(place, x); }
  static Vector broadcast(double x) { return _mm_set1_pd(x); }
};

/// Calls work(lanes, offset) for all columns of an array of doubles with rows of `shape.row` intervals.
template <class Work>
inline void for_each_column(const AxisShape& shape, const Work& work) {
  const std::size_t row = 2 * shape.row;
  const std::size_t block = row * shape.count;
  const bool odd = row % 4 != 0;
  for (std::size_t b = 0; b < shape.blocks; ++b) {
    for (std::size_t column = 0; column + 4 <= row; column += 4) work(NeighbourLanes{}, b * block + column);
  }
  if (!odd) return;
  std::size_t b = 0;
  for (; b + 2 <= shape.blocks; b += 2) work(DistantLanes{block}, b * block + row - 2);
  if (b < shape.blocks) work(SingleLanes{}, b * block + row - 2);
}

/// 2^-k for 0 <= k <= 1022, exactly.
inline double inverse_power_of_two(std::size_t k) {
  return std::bit_cast<double>((std::uint64_t{1023} - k) << 52);
}

/// Calls step(integral_constant<0>), ..., step(integral_constant<N - 1>): a loop unrolled by every compiler.
template <std::size_t N, class Step>
[[gnu::always_inline]] inline void unrolled(const Step& step) {
  [&]<std::size_t... J>(std::index_sequence<J...>) __attribute__((always_inline)) {
    (step(std::integral_constant<std::size_t, J>{}), ...);
  }
  (std::make_index_sequence<N>{});
}

}  // namespace gcslab::kernel_detail
