#pragma once

// How far a walk's boxes may be from the exact dyadic parts of its domain, and what that means for f.
//
// De Casteljau halves exactly; the ends of boxes are midpoints rounded to double. When the ends of a domain
// have few bits (such as [-2, 2]) every end down to the depth is exact and nothing is lost. Otherwise a point
// of a box can lie in the neighbouring exact part, up to `depth` roundings away, and a bound of f on the
// exact part must be widened by the change of f over that distance.

#include "enclosure/range_bound.h"
#include "polynomial/polynomial.h"

namespace gcslab {

/// A number s >= 0 such that, for each box of a walk down to `depth` in each variable and each p in it, the
/// exact dyadic part that the box stands for has a point q with |f(p) - f(q)| <= s. 0 when all ends are
/// exact.
Rational dyadic_slack(const Polynomial& polynomial, const Box& domain, int depth);

}  // namespace gcslab
