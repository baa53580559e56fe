#pragma once

// A curve whose points are figures of a constraint system, with t.

#include "homotopy/curve.h"

namespace gcslab {

class FigureCurve : public Curve {
 public:
  /// The unknowns of the constraint system's equations that belong to a point of the curve.
  virtual std::vector<double> unknowns(std::span<const double> v) const = 0;
};

}  // namespace gcslab
