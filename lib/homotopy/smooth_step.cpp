#include "homotopy/smooth_step.h"

#include <cmath>

namespace gcslab {

double SmoothStep::distance_half_way(const BorderedMatrix& at_b, const CurvePoint& a, const CurvePoint& b) {
  const double span = distance(a.v, b.v);
  for (std::size_t i = 0; i < middle_.size(); ++i) middle_[i] = cubic_between(a, b, span, i).at(0.5);
  if (!curve_->values(middle_, values_)) return HUGE_VAL;
  at_b.solve(values_, 0, change_);
  return norm(change_);
}

}  // namespace gcslab
