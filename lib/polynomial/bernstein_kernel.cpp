// De Casteljau at 1/2 on tensors of FastIntervals, fused in registers.
//
// Level j holds the sums c_j[k] = c_{j-1}[k] + c_{j-1}[k+1]; divided by 2^j they are the coefficients of de
// Casteljau. The left half consists of the first sum of each level and the right half of the last one, so
// only those are scaled, and scaling by a power of two costs no accuracy. Several levels advance together:
// the last sum of each stays in a register, and a coefficient that enters passes through all of them, so that
// the arithmetic, one addition a sum, and not memory bounds the speed.

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "polynomial/upward_kernels.h"
#include "polynomial/vector_lanes.h"

namespace gcslab {
namespace {

using namespace kernel_detail;

/// Levels that one pass takes together; with the entering coefficient they fit into the 16 vector registers.
constexpr int kLevels = 7;
/// Columns up to this long run in code made for their length.
constexpr std::size_t kFusedLength = 32;
/// Coefficients up to this magnitude cannot overflow when kFusedLength - 1 levels are summed without halving.
constexpr double kSafeMagnitude = 0x1p960;

/// Sends x through the first J levels, which keep in `last` what entered them last.
template <std::size_t J, class Vector>
[[gnu::always_inline]] inline Vector through(Vector* last, Vector x) {
  unrolled<J>([&](auto j) __attribute__((always_inline)) {
    const Vector sum = last[j] + x;
    last[j] = x;
    x = sum;
  });
  return x;
}

/// M levels on `count` >= M entries. Afterwards `rest` holds the count - M sums of level M.
template <std::size_t M, class Vector, class Load, class First, class Last>
[[gnu::always_inline]] inline void fused_levels(std::size_t count, const Load& load, Vector* rest,
                                                const First& first, const Last& last) {
  Vector levels[M];
  unrolled<M>([&](auto k) __attribute__((always_inline)) {
    levels[k] = through<k>(levels, load(k));
    first(k, levels[k]);
  });
  for (std::size_t k = M; k < count; ++k) rest[k - M] = through<M>(levels, load(k));
  unrolled<M>([&](auto k) __attribute__((always_inline)) { last(k, levels[k]); });
}

template <class Lanes>
struct Column {
  using Vector = typename Lanes::Vector;
  Lanes lanes;
  const double* source;
  double* left;
  double* right;
  std::size_t row;
  std::size_t degree;

  [[gnu::always_inline]] Vector load(std::size_t k) const { return lanes.load(source + k * row); }
  [[gnu::always_inline]] void store_first(std::size_t level, Vector x) const {
    lanes.store(left + level * row, x * Lanes::broadcast(inverse_power_of_two(level)));
  }
  [[gnu::always_inline]] void store_last(std::size_t level, Vector x) const {
    lanes.store(right + (degree - level) * row, x * Lanes::broadcast(inverse_power_of_two(level)));
  }
};

/// The levels from `Level` on, whose N entries are in `rest`; level 0 comes from the column itself.
template <std::size_t N, std::size_t Level, class Lanes>
[[gnu::always_inline]] inline void remaining_levels(const Column<Lanes>& column,
                                                    typename Lanes::Vector* rest) {
  using Vector = typename Lanes::Vector;
  if constexpr (N > 0) {
    constexpr std::size_t passes = (N + kLevels - 1) / kLevels;
    constexpr std::size_t M = (N + passes - 1) / passes;
    const auto load = [&](std::size_t k) __attribute__((always_inline)) {
      if constexpr (Level == 0) {
        return column.load(k);
      } else {
        return rest[k];
      }
    };
    const auto first = [&](std::size_t k, Vector x) __attribute__((always_inline)) {
      column.store_first(Level + k, x);
    };
    const auto last = [&](std::size_t k, Vector x) __attribute__((always_inline)) {
      column.store_last(Level + k, x);
    };
    fused_levels<M>(N, load, rest, first, last);
    remaining_levels<N - M, Level + M>(column, rest);
  }
}

using FusedHalving = bool (*)(const double*, double*, double*, const AxisShape&);

__m256d widened(__m128d x) { return _mm256_set_m128d(x, x); }
__m256d widened(__m256d x) { return x; }

/// False when a sum overflowed. An overflowing sum is +inf in one of its ends, whatever its sign, and enters
/// the sum of the last level.
template <std::size_t N>
bool halve_fused(const double* source, double* left, double* right, const AxisShape& shape) {
  __m256d top = _mm256_setzero_pd();
  for_each_column(shape, [&](auto lanes, std::size_t offset) {
    using Lanes = decltype(lanes);
    typename Lanes::Vector rest[N];
    const Column<Lanes> column{lanes, source + offset, left + offset, right + offset, 2 * shape.row, N - 1};
    remaining_levels<N, 0>(column, rest);
    top = _mm256_max_pd(top, widened(lanes.load(column.left + (N - 1) * column.row)));
  });
  const __m256d infinity = _mm256_set1_pd(std::numeric_limits<double>::infinity());
  return _mm256_movemask_pd(_mm256_cmp_pd(top, infinity, _CMP_EQ_OQ)) == 0;
}

template <std::size_t... N>
constexpr std::array<FusedHalving, sizeof...(N)> fused_table(std::index_sequence<N...>) {
  return {halve_fused<N + 1>...};
}

constexpr auto kFused = fused_table(std::make_index_sequence<kFusedLength>{});

/// Level by level, halving before each sum: for long columns and for coefficients near the largest double.
void halve_block_stepwise(double* left, double* right, std::size_t count, std::size_t row) {
  for (std::size_t level = 0; level < count; ++level) {
    std::copy_n(right, row, left + level * row);
    const std::size_t sums = (count - 1 - level) * row;
    for (std::size_t i = 0; i < sums; ++i) right[i] = 0.5 * right[i] + 0.5 * right[i + row];
  }
}

void halve_stepwise(const double* source, double* left, double* right, const AxisShape& shape) {
  const std::size_t row = 2 * shape.row;
  const std::size_t block = row * shape.count;
  if (right != source) std::copy_n(source, shape.blocks * block, right);
  for (std::size_t b = 0; b < shape.blocks; ++b) {
    halve_block_stepwise(left + b * block, right + b * block, shape.count, row);
  }
}

bool is_safe(const FastInterval* source, const AxisShape& shape) {
  const __m128d hull = hull_upward(source, shape.blocks * shape.count * shape.row).raw();
  return _mm_movemask_pd(_mm_cmple_pd(hull, _mm_set1_pd(kSafeMagnitude))) == 3;
}

}  // namespace

void halve_bernstein_upward(const FastInterval* source, FastInterval* left, FastInterval* right,
                            const AxisShape& shape) {
  const auto* from = reinterpret_cast<const double*>(source);
  auto* lower = reinterpret_cast<double*>(left);
  auto* upper = reinterpret_cast<double*>(right);
  const bool in_place = left == source || right == source;  // no second try
  const bool fused = shape.count <= kFusedLength && (!in_place || is_safe(source, shape));
  if (fused && kFused[shape.count - 1](from, lower, upper, shape)) return;
  halve_stepwise(from, lower, upper, shape);
}

}  // namespace gcslab
