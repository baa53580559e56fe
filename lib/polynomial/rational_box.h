#pragma once

// Boxes with exact rational ends, on which polynomials are converted exactly.

#include <vector>

#include "interval/interval.h"
#include "interval/rational.h"

namespace gcslab {

/// The reals from `lower` to `upper`; lower <= upper.
struct RationalInterval {
  Rational lower;
  Rational upper;
};

/// One interval a variable.
using RationalBox = std::vector<RationalInterval>;

/// The same box. Throws NotApplicable when it is empty or unbounded.
RationalBox rational_box(const Box& box);

}  // namespace gcslab
