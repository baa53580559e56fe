// Hulls and sums of arrays of FastIntervals.

#include <algorithm>

#include "polynomial/upward_kernels.h"

namespace gcslab {
namespace {

const double* doubles(const FastInterval* values) { return reinterpret_cast<const double*>(values); }

__m128d sum_of_halves(__m256d x) { return _mm256_castpd256_pd128(x) + _mm256_extractf128_pd(x, 1); }

/// The ends of [-1, 1] times the interval.
__m128d symmetric(__m128d x) { return _mm_max_pd(x, _mm_permute_pd(x, 1)); }
__m256d symmetric(__m256d x) { return _mm256_max_pd(x, _mm256_permute_pd(x, 5)); }

/// The ends of [0, 1] times the interval.
__m128d from_zero(__m128d x) { return _mm_max_pd(x, _mm_setzero_pd()); }
__m256d from_zero(__m256d x) { return _mm256_max_pd(x, _mm256_setzero_pd()); }

/// The sum of pair(two intervals) over the array, single(interval) for an odd last one.
template <class Pair, class Single>
FastInterval sum(const FastInterval* values, std::size_t count, const Pair& pair, const Single& single) {
  __m256d total = _mm256_setzero_pd();
  std::size_t i = 0;
  for (; i + 2 <= count; i += 2) total += pair(_mm256_loadu_pd(doubles(values + i)));
  __m128d result = sum_of_halves(total);
  if (i < count) result += single(values[i].raw());
  return FastInterval::from_raw(result);
}

}  // namespace

FastInterval hull_upward(const FastInterval* values, std::size_t count) {
  __m256d hull[4];
  std::fill_n(hull, 4, _mm256_broadcast_pd(reinterpret_cast<const __m128d*>(values)));
  std::size_t i = 0;
  for (; i + 8 <= count; i += 8) {
    for (std::size_t j = 0; j < 4; ++j) {
      hull[j] = _mm256_max_pd(hull[j], _mm256_loadu_pd(doubles(values + i + 2 * j)));
    }
  }
  const __m256d all = _mm256_max_pd(_mm256_max_pd(hull[0], hull[1]), _mm256_max_pd(hull[2], hull[3]));
  __m128d result = _mm_max_pd(_mm256_castpd256_pd128(all), _mm256_extractf128_pd(all, 1));
  for (; i < count; ++i) result = _mm_max_pd(result, values[i].raw());
  return FastInterval::from_raw(result);
}

FastInterval symmetric_sum_upward(const FastInterval* values, std::size_t count) {
  return sum(
      values, count, [](__m256d x) { return symmetric(x); }, [](__m128d x) { return symmetric(x); });
}

FastInterval alternating_sum_upward(const FastInterval* values, std::size_t count) {
  return sum(
      values, count, [](__m256d x) { return _mm256_blend_pd(from_zero(x), symmetric(x), 0b1100); },
      [](__m128d x) { return from_zero(x); });
}

}  // namespace gcslab
