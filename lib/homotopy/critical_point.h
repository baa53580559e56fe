#pragma once

// Points of a curve at which its Jacobian loses rank: where branches cross.

#include <optional>

#include "homotopy/curve.h"

namespace gcslab {

struct CriticalPoint {
  std::vector<double> v;
  /// (H(v) + gap * w, J(v)^T w) = 0 for a unit vector w: 0 where branches cross; where two branches come near
  /// and turn away, about the square of their distance.
  double gap;
};

/// The solution near v0 of Moore's system H(v) + gap w = 0, J(v)^T w = 0, |w| = 1, which is regular at simple
/// bifurcations and where they are perturbed (Moore 1980; Spence, Jepson 1984; second derivatives by
/// differences); nothing where Newton's method does not converge within `radius` of v0.
std::optional<CriticalPoint> critical_point_near(Curve& curve, const std::vector<double>& v0, double radius);

}  // namespace gcslab
