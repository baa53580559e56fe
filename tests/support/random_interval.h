#pragma once

// Random intervals and members of them for tests: points, narrow, wide, tiny, huge, subnormal, unbounded,
// near the extrema and poles of the circular functions, and at the borders of domains.

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/random.h"
#include "interval/interval.h"

namespace gcslab {

/// A double whose sign and binary exponent, in [low, high], are uniform.
inline double random_magnitude(Random& random, int low, int high) {
  const double mantissa = random.uniform(1, 2) * (random.below(2) == 0 ? 1 : -1);
  return std::ldexp(mantissa, static_cast<int>(random.integer(low, high)));
}

/// One number of a kind that arithmetic finds hard, or a plain one.
inline double random_double(Random& random) {
  switch (random.below(10)) {
    case 0:
      return static_cast<double>(random.integer(-4, 4));
    case 1:
      return random_magnitude(random, -1074, -1020);
    case 2:
      return random_magnitude(random, 1000, 1023);
    case 3:
      return random_magnitude(random, -1074, 1023);
    case 4: {  // beside a multiple of pi/2
      const double multiple = static_cast<double>(random.integer(-40, 40)) * (std::numbers::pi / 2);
      return multiple + static_cast<double>(random.integer(-2, 2)) * std::fabs(multiple) * 0x1p-52;
    }
    case 5:  // beside 1
      return (1 + static_cast<double>(random.integer(-4, 4)) * 0x1p-53) * (random.below(2) == 0 ? 1 : -1);
    case 6:
      return random_magnitude(random, -30, 60);
    case 7:
      return random.uniform(-1, 1);
    default:
      return random.uniform(-10, 10);
  }
}

/// A nonempty interval; bounded ones are the most.
inline Interval random_interval(Random& random) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const double x = random_double(random);
  switch (random.below(12)) {
    case 0:
    case 1:
      return x;
    case 2:
      return {x, std::nextafter(x, kInfinity) < kInfinity ? std::nextafter(x, kInfinity) : x};
    case 3: {  // narrow, relative to its size
      const double size = std::fabs(x) * std::ldexp(random.unit(), -static_cast<int>(random.integer(0, 50)));
      return std::isfinite(x + size) ? Interval(x, x + size) : Interval(x);
    }
    case 4:
      return {x, kInfinity};
    case 5:
      return {-kInfinity, x};
    case 6:
      return random.below(8) == 0 ? Interval::entire() : Interval(std::min(x, 0.0), std::max(x, 0.0));
    case 7:
    case 8: {
      const double width = random.uniform(0, 4);
      const double lower = random.uniform(-4, 4);
      return {lower, lower + width};
    }
    default: {
      const double y = random_double(random);
      return {std::min(x, y), std::max(x, y)};
    }
  }
}

/// A finite member: often an end, 0, or an integer.
inline double random_member(Random& random, const Interval& x) {
  const Interval bounded =
      intersection(x, {-std::numeric_limits<double>::max(), std::numeric_limits<double>::max()});
  switch (random.below(5)) {
    case 0:
      return bounded.lower;
    case 1:
      return bounded.upper;
    case 2: {
      const double whole = std::clamp(std::rint(random.uniform(-3, 3)), bounded.lower, bounded.upper);
      return contains(bounded, 0) && random.below(3) == 0 ? 0 : whole;
    }
    default: {
      const double t = random.unit();
      return std::clamp(bounded.lower * (1 - t) + bounded.upper * t, bounded.lower, bounded.upper);
    }
  }
}

}  // namespace gcslab
