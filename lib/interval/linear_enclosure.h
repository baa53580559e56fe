#pragma once

// Enclosures of a function of one variable between two parallel lines (de Figueiredo, Stolfi 2004, section
// 4).

#include <optional>

#include "interval/interval.h"
#include "interval/univariate_function.h"

namespace gcslab {

/// Which of the enclosing pairs of lines is taken.
enum class Approximation {
  chebyshev,  ///< the nearest pair, parallel to the secant, where the function is convex or concave
  min_range   ///< the pair whose values over the interval have the least range
};

/// f(x) lies in slope * x + offset for all x of an interval.
struct LinearEnclosure {
  double slope;
  Interval offset;
};

/// An enclosure of f on x, a bounded part of f's domain; none where no useful one is found: an unbounded
/// derivative, or a function that is not monotone for min_range. Where the curvature is mixed, Chebyshev's is
/// the min_range one. Needs upward rounding.
std::optional<LinearEnclosure> enclose_linearly(const UnivariateFunction& f, const Interval& x,
                                                Approximation approximation);

/// The same for |x|, which is not differentiable.
std::optional<LinearEnclosure> enclose_absolute_value(const Interval& x, Approximation approximation);

}  // namespace gcslab
