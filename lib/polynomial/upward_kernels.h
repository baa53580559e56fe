#pragma once

// The inner loops of polynomial bounds over FastInterval: halving in both bases, and ranges.
//
// Promise: called under UpwardRounding on intervals none of which is empty, each result encloses the exact
// result for every choice of members.
//
// An array of FastIntervals is an array of doubles (-lower, upper, ...). Sums of these, and products with
// positive numbers, round both ends outward when rounded upward; so the loops work on vectors of four doubles
// and never look at signs. They live in source files of their own, called from inside the scope, so that no
// compiler moves their arithmetic out of it.

#include <cstddef>

#include "interval/fast_interval.h"
#include "polynomial/tensor.h"

namespace gcslab {

/// Bernstein coefficients of both halves of [0, 1] in the variable that `shape` belongs to (de Casteljau at
/// 1/2). `left` or `right` may be `source`.
void halve_bernstein_upward(const FastInterval* source, FastInterval* left, FastInterval* right,
                            const AxisShape& shape);

/// Coefficients in powers of w on [-1, 1] of p((w - 1) / 2) and p((w + 1) / 2), the two halves of z in [-1,
/// 1]. `left` or `right` may be `source`. False, and nothing done, when `shape.count` is above 64.
[[nodiscard]] bool halve_power_upward(const FastInterval* source, FastInterval* left, FastInterval* right,
                                      const AxisShape& shape);

/// The hull of `count` > 0 intervals.
FastInterval hull_upward(const FastInterval* values, std::size_t count);

/// The sum of [-1, 1] times each of `count` intervals.
FastInterval symmetric_sum_upward(const FastInterval* values, std::size_t count);

/// The same, but where the position is even, [0, 1] takes the place of [-1, 1].
FastInterval alternating_sum_upward(const FastInterval* values, std::size_t count);

}  // namespace gcslab
