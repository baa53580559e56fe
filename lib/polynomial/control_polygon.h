#pragma once

// Where a function of one variable can vanish, given intervals for its Bernstein coefficients.
//
// The coefficients stand over t = j / d, j = 0 .. d. Whatever function lies between the polynomials of the
// lower and of the upper ends has its zeros t in [0, 1] where that band meets the axis. Both functions below
// enclose that set, rounded outward; they give [0, 1] when a coefficient is unbounded.

#include <span>

#include "interval/interval.h"

namespace gcslab {

/// The part of the axis inside the convex hull of all points (j / d, b), b in coefficients[j] (Sherbrooke and
/// Patrikalakis 1993). Hulls of the lower and of the upper points are found by Andrew's monotone chain (1979)
/// with exact orientation tests.
Interval hull_crossings(std::span<const Interval> coefficients);

/// From the first to the last point where the polynomials of the lower and of the upper ends enclose 0
/// (Mourrain and Pavone 2009): `hull_crossings` repeated on what is left at either end. A subset of
/// hull_crossings, of which little is missing.
Interval polynomial_crossings(std::span<const Interval> coefficients);

}  // namespace gcslab
