#pragma once

// The loops over all constraints of one simplex step, four at a time. Arrays have `stride` elements, a
// multiple of four; padding holds rate 0 and infinite sides.

#include <cstddef>

namespace gcslab::simplex_kernel {

struct Blocking {
  double step;             ///< how far the rates may be followed; infinite when nothing blocks
  std::size_t constraint;  ///< what blocks
};

/// The two-pass ratio test of Harris (1973): of the constraints that would be violated by at most `tolerance`
/// at the step chosen, the one with the largest rate blocks. Rates below `smallest_rate` do not count.
Blocking ratio_test(const double* value, const double* rate, const double* lower, const double* upper,
                    std::size_t stride, double tolerance, double smallest_rate);

struct Violation {
  double amount;           ///< <= 0 when everything holds
  std::size_t constraint;  ///< the one violated most
};

Violation largest_violation(const double* value, const double* lower, const double* upper,
                            std::size_t stride);

/// Of the elements with fall > smallest_fall, fall = -inward * multiplier, the one with the largest fall^2 /
/// squared_length; `count` when there is none. The arrays have count elements, padded with zeros (lengths:
/// ones) to a multiple of four.
std::size_t steepest(const double* inward, const double* multiplier, const double* squared_length,
                     std::size_t count, double smallest_fall);

/// Of the slots whose pivot, direction * inward * along, is more than smallest_pivot, the one whose
/// multiplier inward * multiplier first reaches zero; of those that do up to `tolerance` later the one with
/// the largest pivot (Harris 1973). `count` when there is none. The arrays are padded with zeros to a
/// multiple of four.
std::size_t first_to_reach_zero(const double* inward, const double* multiplier, const double* along,
                                double direction, std::size_t count, double tolerance, double smallest_pivot);

/// value += step * rate.
void advance(double* value, const double* rate, double step, std::size_t stride);

}  // namespace gcslab::simplex_kernel
