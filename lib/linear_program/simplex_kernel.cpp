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

/// The smallest (room + tolerance) / |rate|. Divides only where that is smaller than what was found before.
double loosest_step(const double* value, const double* rate, const double* lower, const double* upper,
                    std::size_t stride, double tolerance, double smallest_rate) {
  const __m256d smallest_rates = _mm256_set1_pd(smallest_rate);
  __m256d smallest = _mm256_set1_pd(kInfinity);
  for (std::size_t k = 0; k < stride; k += 4) {
    const __m256d rates = _mm256_loadu_pd(rate + k);
    const __m256d sizes = magnitude(rates);
    const __m256d ahead = _mm256_add_pd(room(value, rates, lower, upper, k), _mm256_set1_pd(tolerance));
    const __m256d counts = _mm256_cmp_pd(sizes, smallest_rates, _CMP_GT_OQ);
    const __m256d nearer = _mm256_cmp_pd(ahead, _mm256_mul_pd(smallest, sizes), _CMP_LT_OQ);
    const __m256d improves = _mm256_and_pd(counts, nearer);
    if (_mm256_testz_pd(improves, improves)) continue;
    smallest = _mm256_blendv_pd(smallest, _mm256_div_pd(ahead, sizes), improves);
    smallest = _mm256_set1_pd(smallest_of(smallest));
  }
  return smallest_of(smallest);
}

}  // namespace

Blocking ratio_test(const double* value, const double* rate, const double* lower, const double* upper,
                    std::size_t stride, double tolerance, double smallest_rate) {
  const double loosest = loosest_step(value, rate, lower, upper, stride, tolerance, smallest_rate);
  Blocking result{kInfinity, 0};
  if (loosest == kInfinity) return result;
  double largest_rate = smallest_rate;
  for (std::size_t k = 0; k < stride; k += 4) {
    const __m256d rates = _mm256_loadu_pd(rate + k);
    const __m256d sizes = magnitude(rates);
    const __m256d larger = _mm256_cmp_pd(sizes, _mm256_set1_pd(largest_rate), _CMP_GT_OQ);
    const __m256d ahead = room(value, rates, lower, upper, k);
    const __m256d blocks = _mm256_cmp_pd(ahead, _mm256_mul_pd(sizes, _mm256_set1_pd(loosest)), _CMP_LE_OQ);
    const auto eligible = static_cast<unsigned>(_mm256_movemask_pd(_mm256_and_pd(larger, blocks)));
    if (eligible == 0) continue;
    alignas(32) double rooms[4];
    _mm256_store_pd(rooms, ahead);
    for (std::size_t i = 0; i < 4; ++i) {
      const double size = std::abs(rate[k + i]);
      if ((eligible >> i & 1U) == 0 || !(size > largest_rate)) continue;
      largest_rate = size;
      result = {rooms[i] / size, k + i};
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

std::size_t steepest(const double* inward, const double* multiplier, const double* squared_length,
                     std::size_t count, double smallest_fall) {
  std::size_t best = count;
  double best_score = 0;
  for (std::size_t k = 0; k < count; k += 4) {
    const __m256d gain = _mm256_mul_pd(_mm256_loadu_pd(inward + k), _mm256_loadu_pd(multiplier + k));
    const __m256d falls = _mm256_cmp_pd(gain, _mm256_set1_pd(-smallest_fall), _CMP_LT_OQ);
    const __m256d square = _mm256_mul_pd(gain, gain);
    const __m256d least = _mm256_mul_pd(_mm256_set1_pd(best_score), _mm256_loadu_pd(squared_length + k));
    const __m256d better = _mm256_cmp_pd(square, least, _CMP_GT_OQ);
    const auto eligible = static_cast<unsigned>(_mm256_movemask_pd(_mm256_and_pd(falls, better)));
    if (eligible == 0) continue;
    alignas(32) double squares[4];
    _mm256_store_pd(squares, square);
    for (std::size_t i = 0; i < 4; ++i) {
      if ((eligible >> i & 1U) == 0 || squares[i] <= best_score * squared_length[k + i]) continue;
      best_score = squares[i] / squared_length[k + i];
      best = k + i;
    }
  }
  return best;
}

std::size_t first_to_reach_zero(const double* inward, const double* multiplier, const double* along,
                                double direction, std::size_t count, double tolerance,
                                double smallest_pivot) {
  const __m256d directions = _mm256_set1_pd(direction);
  const auto pivots_at = [&](std::size_t k) {
    return _mm256_mul_pd(_mm256_mul_pd(directions, _mm256_loadu_pd(inward + k)), _mm256_loadu_pd(along + k));
  };
  const auto sizes_at = [&](std::size_t k) {
    return _mm256_max_pd(_mm256_mul_pd(_mm256_loadu_pd(inward + k), _mm256_loadu_pd(multiplier + k)),
                         _mm256_setzero_pd());
  };
  double loosest = kInfinity;
  for (std::size_t k = 0; k < count; k += 4) {
    const __m256d pivots = pivots_at(k);
    const __m256d ahead = _mm256_add_pd(sizes_at(k), _mm256_set1_pd(tolerance));
    const __m256d counts = _mm256_cmp_pd(pivots, _mm256_set1_pd(smallest_pivot), _CMP_GT_OQ);
    const __m256d sooner = _mm256_cmp_pd(ahead, _mm256_mul_pd(_mm256_set1_pd(loosest), pivots), _CMP_LT_OQ);
    const __m256d improves = _mm256_and_pd(counts, sooner);
    if (_mm256_testz_pd(improves, improves)) continue;
    loosest = smallest_of(_mm256_blendv_pd(_mm256_set1_pd(loosest), _mm256_div_pd(ahead, pivots), improves));
  }
  std::size_t best = count;
  double largest = smallest_pivot;
  for (std::size_t k = 0; k < count; k += 4) {
    const __m256d pivots = pivots_at(k);
    const __m256d larger = _mm256_cmp_pd(pivots, _mm256_set1_pd(largest), _CMP_GT_OQ);
    const __m256d soon =
        _mm256_cmp_pd(sizes_at(k), _mm256_mul_pd(_mm256_set1_pd(loosest), pivots), _CMP_LE_OQ);
    const auto eligible = static_cast<unsigned>(_mm256_movemask_pd(_mm256_and_pd(larger, soon)));
    if (eligible == 0) continue;
    alignas(32) double lanes[4];
    _mm256_store_pd(lanes, pivots);
    for (std::size_t i = 0; i < 4; ++i) {
      if ((eligible >> i & 1U) == 0 || !(lanes[i] > largest)) continue;
      largest = lanes[i];
      best = k + i;
    }
  }
  return best;
}

void advance(double* value, const double* rate, double step, std::size_t stride) {
  const __m256d steps = _mm256_set1_pd(step);
  for (std::size_t k = 0; k < stride; k += 4) {
    const __m256d moved = _mm256_fmadd_pd(steps, _mm256_loadu_pd(rate + k), _mm256_loadu_pd(value + k));
    _mm256_storeu_pd(value + k, moved);
  }
}

}  // namespace gcslab::simplex_kernel
