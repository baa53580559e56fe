#pragma once

// Whether a step stayed on one smooth branch.

#include "homotopy/curve_point.h"

namespace gcslab {

class SmoothStep {
 public:
  /// The curve must outlive it.
  explicit SmoothStep(Curve& curve)
      : curve_(&curve), middle_(curve.size() + 1), values_(curve.size()), change_(curve.size() + 1) {}

  /// How far the cubic between two points of a curve, with their tangents, lies from the curve half way: one
  /// change of Newton's method there, with `at_b`, the factorised (J; border) at b. Infinite where the
  /// equations are undefined there.
  ///
  /// Between points h apart on a smooth branch it is h^4 |v''''| / 384, by Hermite's interpolation, and a
  /// sixtieth of the error of the cubic that was extrapolated from a step before as long. Where a step goes
  /// over to another branch, d aside or at the angle d / h, it is of the order of d.
  double distance_half_way(const BorderedMatrix& at_b, const CurvePoint& a, const CurvePoint& b);

 private:
  Curve* curve_;
  std::vector<double> middle_, values_, change_;
};

}  // namespace gcslab
