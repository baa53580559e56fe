#pragma once

// All intersections of two curves in the plane.
//
// Promise: each listed point is an intersection, which the solver has certified or exact arithmetic has
// found, and is listed once (for each pair of its parameters, where a
// curve passes it more than once). Every other intersection has its parameters in an undecided box; when
// there is none, the list is proved to be complete. Undecided are what no certificate of simple roots can
// settle: points where the curves are tangent, and common arcs.
//
// Method: two pieces a(s) / w(s), b(t) / z(t) meet where a(s) z(t) - b(t) w(s) = 0, a polynomial system in
// the two local parameters that the branch-and-prune engine (lib/box_solver, method adaptive) solves on [0,
// 1]^2, unless the boxes of their control points are disjoint. Points at ends of pieces, which belong to more
// than one pair, are found first by themselves: the end is an exact point, and the parameters on the other
// curve at which it is met are the common roots of two polynomials, told exactly (lib/univariate). A root of
// the engine whose uniqueness box contains such a point is that point.

#include "interval/interval.h"
#include "spline/rational_curve.h"

namespace gcslab {

struct IntersectionOptions {
  std::uint64_t maximum_boxes = 20'000;  ///< work budget for one pair of pieces
  std::uint64_t cluster_boxes = 500;     ///< the part of it that one tangency may take
};

/// Intervals contain the exact values.
struct CurveIntersection {
  Interval first;   ///< parameter on the first curve
  Interval second;  ///< and on the second
  Box point;        ///< its two coordinates
};

/// Parameters of the two curves where there may be more.
struct UndecidedIntersection {
  Interval first;
  Interval second;
  std::string reason;
};

struct CurveIntersections {
  std::vector<CurveIntersection> points;         ///< by ascending first parameters
  std::vector<UndecidedIntersection> undecided;  ///< empty: the list is complete

  bool is_complete() const { return undecided.empty(); }
};

/// Of polynomial and rational curves. Throws InputError unless both have two coordinates.
CurveIntersections intersections(const BSplineCurve<double>& first, const BSplineCurve<double>& second,
                                 const IntersectionOptions& options = {});
CurveIntersections intersections(const RationalCurve<double>& first, const RationalCurve<double>& second,
                                 const IntersectionOptions& options = {});
CurveIntersections intersections(const RationalCurve<double>& first, const BSplineCurve<double>& second,
                                 const IntersectionOptions& options = {});

}  // namespace gcslab
