#include "linear_program/simplex_kernel.h"

#include <algorithm>
#include <cmath>
#include <immintrin.h>
#include <limits>

namespace gcslab::simplex_kernel {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

__m256d magnitude(__m256d x) { return _mm256_andnot_pd(_mm256_set1_pd(-0.0), x); }

double smallest_of(__m256d x) {
  const __m128d pair = _mm_min_pd(_mm256_castpd256_pd128(x), _mm256_extractf128_pd(x, 1));
  return std::min(_mm_cvtsd_f64(pair), _mm_cvtsd_f64(_mm_unpackhi_pd(pair, pair)));
}

/// The distance to the side that the rates lead to, at least 0.
__m256d room(const double* value, __m256d rate, const double* lower, const double* upper, std::size_t k) {
  const __m256d v = _mm256_loadu_pd(value + k);
  const __m256d above = _mm256_sub_pd(_mm256_loadu_pd(upper + k), v);
  const __m256d below = _mm256_sub_pd(v, _mm256_loadu_pd(lower + k));
  const __m256d ahead = _mm256_blendv_pd(above, below, rate);  // by the sign of the rate
  return _mm256_max_pd(ahead, _mm256_setzero_pd());
}

/// The smallest (room + tolerance) / |rate|.
double loosest_step(const double* value, const double* rate, const double* lower, const double* upper,
                    std::size_t stride, double tolerance, double smallest_rate) {
  __m256d smallest = _mm256_set1_pd(kInfinity);
  for (std::size_t k = 0; k < stride; k += 4) {
    const __m256d rates = _mm256_loadu_pd(rate + k);
    const __m256d counts = _mm256_cmp_pd(magnitude(rates), _mm256_set1_pd(smallest_rate), _CMP_GT_OQ);
    if (_mm256_testz_pd(counts, counts)) continue;
    const __m256d ahead = _mm256_add_pd(room(value, rates, lower, upper, k), _mm256_set1_pd(tolerance));
    const __m256d steps = _mm256_div_pd(ahead, magnitude(rates));
    smallest = _mm256_min_pd(smallest, _mm256_blendv_pd(_mm256_set1_pd(kInfinity), steps, counts));
  }
  return smallest_of(smallest);
}

}  // namespace

Blocking ratio_test(const double* value, const double* rate, const double* lower, const double* upper,
                    std::size_t stride, double tolerance, double smallest_rate) {
  const double loosest = loosest_step(value, rate, lower, upper, stride, tolerance, smallest_rate);
  Blocking result{kInfinity, 0};
  double largest_rate = smallest_rate;
  for (std::size_t k = 0; k < stride && loosest < kInfinity; k += 4) {
    const __m256d rates = _mm256_loadu_pd(rate + k);
    const __m256d counts = _mm256_cmp_pd(magnitude(rates), _mm256_set1_pd(largest_rate), _CMP_GT_OQ);
    if (_mm256_testz_pd(counts, counts)) continue;
    for (std::size_t i = k; i < k + 4; ++i) {
      const double size = std::abs(rate[i]);
      if (!(size > largest_rate)) continue;
      const double ahead = std::max(rate[i] > 0 ? upper[i] - value[i] : value[i] - lower[i], 0.0);
      if (ahead > loosest * size) continue;
      largest_rate = size;
      result = {ahead / size, i};
    }
  }
  return result;
}

Violation largest_violation(const double* value, const double* lower, const double* upper,
                            std::size_t stride) {
  Violation result{-kInfinity, 0};
  for (std::size_t k = 0; k < stride; k += 4) {
    const __m256d v = _mm256_loadu_pd(value + k);
    const __m256d amount = _mm256_max_pd(_mm256_sub_pd(_mm256_loadu_pd(lower + k), v),
                                         _mm256_sub_pd(v, _mm256_loadu_pd(upper + k)));
    const __m256d larger = _mm256_cmp_pd(amount, _mm256_set1_pd(result.amount), _CMP_GT_OQ);
    if (_mm256_testz_pd(larger, larger)) continue;
    alignas(32) double amounts[4];
    _mm256_store_pd(amounts, amount);
    for (std::size_t i = 0; i < 4; ++i) {
      if (amounts[i] > result.amount) result = {amounts[i], k + i};
    }
  }
  return result;
}

void advance(double* value, const double* rate, double step, std::size_t stride) {
  const __m256d steps = _mm256_set1_pd(step);
  for (std::size_t k = 0; k < stride; k += 4) {
    const __m256d moved = _mm256_fmadd_pd(steps, _mm256_loadu_pd(rate + k), _mm256_loadu_pd(value + k));
    _mm256_storeu_pd(value + k, moved);
  }
}

}  // namespace gcslab::simplex_kernel
