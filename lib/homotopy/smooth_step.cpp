#include "homotopy/smooth_step.h"

#include <cmath>

namespace gcslab {

double distance_half_way(Curve& curve, const BorderedMatrix& at_b, const CurvePoint& a, const CurvePoint& b) {
  std::vector<double> values(curve.size()), change(curve.size() + 1);
  if (!curve.values(point_between(a, b, 0.5), values)) return HUGE_VAL;
  at_b.solve(values, 0, change);
  return norm(change);
}

}  // namespace gcslab
