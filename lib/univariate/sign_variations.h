#pragma once

// Sign variations of numbers that are known as intervals.

#include <span>

#include "interval/fast_interval.h"

namespace gcslab {

/// Bounds of the number of sign changes in a sequence, zeros left out.
struct SignVariations {
  int least;
  int most;
};

/// Bounds over all choices of one number from each interval.
SignVariations sign_variations(std::span<const FastInterval> numbers);

}  // namespace gcslab
