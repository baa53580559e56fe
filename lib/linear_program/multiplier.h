#pragma once

// Which multipliers of a row mean something: the one rule that rounded, rigorous and exact bounds share.

#include <cmath>

#include "interval/interval.h"

namespace gcslab {

/// The side that a multiplier holds the row at: the lower one when positive.
inline double held_side(double multiplier, const Interval& sides) {
  return multiplier > 0 ? sides.lower : sides.upper;
}

/// The multiplier, or 0 when it is not finite or would hold the row at an infinite side.
inline double usable_multiplier(double multiplier, const Interval& sides) {
  return std::isfinite(multiplier) && std::isfinite(held_side(multiplier, sides)) ? multiplier : 0;
}

}  // namespace gcslab
