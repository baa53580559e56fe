#pragma once

// The points of a curve that are closest to a given point, all over the curve.
//
// A closest point is an end of a piece or a root of (P - Q).P' on it: of a polynomial of degree 2d - 1, for
// rational curves 3d - 1, whose roots are isolated exactly (lib/univariate). Pieces whose control box is too
// far away are left out.

#include <span>

#include "spline/rational_curve.h"

namespace gcslab {

/// Intervals contain the exact values.
struct ClosestPoint {
  Interval parameter;
  Box point;
  Interval distance;
};

/// All global minimisers of the distance to a point, by ascending parameters, and all its critical points and
/// ends of spans at which it exceeds the minimum by no more than the tolerance. Of a piece on which the
/// distance is constant only the ends are listed. Throws InputError for a point of another dimension or that
/// is not finite, or a negative tolerance.
std::vector<ClosestPoint> closest_points(const BSplineCurve<double>& curve, std::span<const double> point,
                                         double tolerance = 0);
std::vector<ClosestPoint> closest_points(const RationalCurve<double>& curve, std::span<const double> point,
                                         double tolerance = 0);

}  // namespace gcslab
