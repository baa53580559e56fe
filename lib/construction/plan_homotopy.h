#pragma once

// The homotopy of a sketch, in the coordinates of a construction plan.

#include <optional>

#include "construction/plan_curve.h"
#include "homotopy/sketch_homotopy.h"

namespace gcslab {

class PlanHomotopy {
 public:
  /// The path of `sketched`, which must outlive it. Throws NotApplicable as make_plan, PlanProgram and
  /// PlanCurve do.
  PlanHomotopy(const ConstraintSystem& system, const Frame& frame, const GeometricEquations& equations,
               const SketchHomotopy& sketched, PlanKind kind);

  const PlanProgram& program() const { return *program_; }
  const PlanMotion& motion() const { return *motion_; }
  /// What the sketch shows.
  const PlanValues& start() const { return start_; }
  PlanCurve& curve() { return *curve_; }
  const PlanCurve& curve() const { return *curve_; }

 private:
  std::optional<PlanProgram> program_;
  std::optional<PlanMotion> motion_;
  PlanValues start_;
  std::optional<PlanCurve> curve_;
};

}  // namespace gcslab
