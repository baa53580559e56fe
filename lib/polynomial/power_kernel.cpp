// Halving in the power basis: z = (w -+ 1) / 2 put into sum a_k z^k, fused in registers.
//
// With c_k = a_k / 2^k, the upper half is the Taylor shift sum c_k (w + 1)^k, computed by additions alone:
// level j holds the sums s_j[k] = s_{j-1}[k] + s_j[k+1] for k = d, ..., j, and s_j[j] is the coefficient of
// w^j (Horner's scheme, repeated). The lower half, sum c_k (w - 1)^k, is the same with the signs of all odd
// coefficients changed before and after. Several levels advance together, as in bernstein_kernel.cpp.
// Sums stay below twice the largest coefficient; should one overflow all the same, the result is unbounded.

#include <algorithm>
#include <array>

#include "polynomial/upward_kernels.h"
#include "polynomial/vector_lanes.h"

namespace gcslab {
namespace {

using namespace kernel_detail;

constexpr std::size_t kLevels = 7;
/// Longest column that is kept on the stack.
constexpr std::size_t kLongest = 64;

__m128d negated(__m128d x) { return _mm_permute_pd(x, 1); }
__m256d negated(__m256d x) { return _mm256_permute_pd(x, 5); }

/// Adds x to the first J running sums, each of which enters the next; returns the last.
template <std::size_t J, class Vector>
[[gnu::always_inline]] inline Vector through(Vector* sums, Vector x) {
  unrolled<J>([&](auto j) __attribute__((always_inline)) { x = sums[j] += x; });
  return x;
}

/// M levels on `count` >= M entries. Afterwards the first M entries are coefficients and the others sums of
/// level M.
template <std::size_t M, class Vector>
void fused_levels(Vector* entries, std::size_t count) {
  Vector sums[M];
  std::fill_n(sums, M, entries[count - 1]);
  if (count == M) {
    unrolled<M - 1>([&](auto i) { entries[M - 2 - i] = through<M - 1 - i>(sums, entries[M - 2 - i]); });
    return;
  }
  for (std::size_t k = count - 1; k-- > M;) entries[k] = through<M>(sums, entries[k]);
  unrolled<M>([&](auto i) { entries[M - 1 - i] = through<M - i>(sums, entries[M - 1 - i]); });
}

template <class Vector, std::size_t... M>
constexpr std::array<void (*)(Vector*, std::size_t), sizeof...(M)> level_table(std::index_sequence<M...>) {
  return {fused_levels<M + 1, Vector>...};
}

/// Replaces the coefficients c_k by those of sum c_k (w + 1)^k.
template <class Vector>
void shift_by_one(Vector* entries, std::size_t count) {
  static constexpr auto kTable = level_table<Vector>(std::make_index_sequence<kLevels>{});
  while (count > 0) {
    const std::size_t levels = std::min(count, kLevels);
    kTable[levels - 1](entries, count);
    entries += levels;
    count -= levels;
  }
}

template <class Vector>
void negate_odd(Vector* entries, std::size_t count) {
  for (std::size_t k = 1; k < count; k += 2) entries[k] = negated(entries[k]);
}

template <class Lanes>
void halve_column(Lanes lanes, const double* source, double* left, double* right, std::size_t count,
                  std::size_t row) {
  using Vector = typename Lanes::Vector;
  Vector upper[kLongest];
  Vector lower[kLongest];
  for (std::size_t k = 0; k < count; ++k) {
    upper[k] = lanes.load(source + k * row) * Lanes::broadcast(inverse_power_of_two(k));
  }
  std::copy_n(upper, count, lower);
  negate_odd(lower, count);
  shift_by_one(upper, count);
  shift_by_one(lower, count);
  negate_odd(lower, count);
  for (std::size_t k = 0; k < count; ++k) {
    lanes.store(left + k * row, lower[k]);
    lanes.store(right + k * row, upper[k]);
  }
}

}  // namespace

bool halve_power_upward(const FastInterval* source, FastInterval* left, FastInterval* right,
                        const AxisShape& shape) {
  if (shape.count > kLongest) return false;
  for_each_column(shape, [&](auto lanes, std::size_t offset) {
    halve_column(lanes, reinterpret_cast<const double*>(source) + offset,
                 reinterpret_cast<double*>(left) + offset, reinterpret_cast<double*>(right) + offset,
                 shape.count, 2 * shape.row);
  });
  return true;
}

}  // namespace gcslab
