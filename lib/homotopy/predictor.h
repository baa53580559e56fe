#pragma once

// Where a curve is likely to be a step further on (Allgower, Georg 1990, chapters 2, 6 and 10).

#include <memory>
#include <string>

#include "base/registry.h"
#include "homotopy/curve_point.h"

namespace gcslab {

class Predictor {
 public:
  virtual ~Predictor() = default;
  /// The point at arc length about `step` after `here`; `before` is the accepted point before it, null at the
  /// start. False where a slope that is needed does not exist.
  virtual bool predict(const CurvePoint& here, const CurvePoint* before, double step,
                       std::vector<double>& result) = 0;
  /// The error is O(step^order).
  virtual int order() const = 0;
};

struct PredictorKind {
  std::string name;
  std::string summary;
  std::unique_ptr<Predictor> (*make)(Curve&);
};

/// euler, heun, runge_kutta, secant, hermite.
const Registry<PredictorKind>& predictor_registry();

}  // namespace gcslab
