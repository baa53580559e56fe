#pragma once

// The homotopy of a sketch, in the coordinates of a construction plan.

#include <optional>

#include "construction/plan_curve.h"
#include "homotopy/sketch_homotopy.h"

namespace gcslab {

class PlanHomotopy {
 public:
  /// The path of `sketched`, which must outlive it, by the plan of that kind. Throws NotApplicable as
  /// make_plan, PlanProgram and PlanCurve do.
  PlanHomotopy(const ConstraintSystem& system, const Frame& frame, const GeometricEquations& equations,
               const SketchHomotopy& sketched, PlanKind kind);
  /// By a given plan, whose curve is balanced at `figure`, on the path at t.
  PlanHomotopy(const ConstraintSystem& system, const Frame& frame, const GeometricEquations& equations,
               const SketchHomotopy& sketched, Plan plan, const Figure& figure, double t);

  const PlanProgram& program() const { return *program_; }
  const PlanMotion& motion() const { return *motion_; }
  /// What that figure shows, in the first case the sketch, with the offsets of t = 0.
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
