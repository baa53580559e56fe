#pragma once

// Boxes and hulls around curves.

#include <span>

#include "spline/rational_curve.h"

namespace gcslab {

/// The box of the control points that the curve depends on: it contains the curve, since basis functions are
/// nonnegative and sum to 1.
template <class T>
Box control_box(const BSplineCurve<T>& curve) {
  Box box(curve.dimension());
  for (const std::size_t span : curve.knots.spans()) {
    for (std::size_t i = span - static_cast<std::size_t>(curve.degree()); i <= span; ++i) {
      for (std::size_t c = 0; c < box.size(); ++c)
        box[c] = hull(box[c], NumberTraits<T>::enclosure(curve.points(i, c)));
    }
  }
  return box;
}

/// The smallest box that contains the curve, rounded outward: the extreme values of each coordinate at ends
/// of spans and at the roots of its derivative, which are isolated exactly (lib/univariate).
Box bounding_box(const BSplineCurve<Rational>& curve);
Box bounding_box(const RationalCurve<Rational>& curve);
inline Box bounding_box(const BSplineCurve<double>& curve) {
  return bounding_box(converted<Rational>(curve));
}
inline Box bounding_box(const RationalCurve<double>& curve) {
  return bounding_box(converted<Rational>(curve));
}

/// Whether a point of the plane lies in the convex hull of others, its border included: exactly. Throws
/// InputError unless all have two coordinates.
bool is_in_convex_hull(const Matrix<Rational>& points, std::span<const Rational> point);

/// The convex hull property of a plane curve at a parameter: the point lies in the hull of the d + 1 control
/// points of its span. True for every curve; what an implementation can be checked by.
bool has_convex_hull_property(const BSplineCurve<Rational>& curve, const Rational& u);

}  // namespace gcslab
