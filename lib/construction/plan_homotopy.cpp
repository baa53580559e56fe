#include "construction/plan_homotopy.h"

#include <utility>

namespace gcslab {
namespace {

Figure sketch_of(const GeometricEquations& equations, const SketchHomotopy& sketched) {
  return figure_at(equations, sketched.curve().unknowns(sketched.start()));
}

/// Constraints that do not move hold all along.
OffsetMotion offset_motion(const ConstraintSystem& system, const GeometricEquations& equations,
                           const Homotopy& homotopy) {
  std::vector<double> start(system.constraints.size(), 0.0), leading(start);
  for (const EquationOffset& offset : homotopy.offsets()) {
    const std::optional<std::size_t> constraint = equations.constraint_of_equation[offset.equation];
    if (!constraint) continue;
    start[*constraint] = offset.start / homotopy.weights()[offset.equation];
    leading[*constraint] = offset.leading / homotopy.weights()[offset.equation];
  }
  return {std::move(start), std::move(leading)};
}

}  // namespace

PlanHomotopy::PlanHomotopy(const ConstraintSystem& system, const Frame& frame,
                           const GeometricEquations& equations, const SketchHomotopy& sketched, PlanKind kind)
    : PlanHomotopy(system, frame, equations, sketched,
                   make_plan(system, kind, sketch_of(equations, sketched)), sketch_of(equations, sketched),
                   0) {}

PlanHomotopy::PlanHomotopy(const ConstraintSystem& system, const Frame& frame,
                           const GeometricEquations& equations, const SketchHomotopy& sketched, Plan plan,
                           const Figure& figure, double t) {
  const Homotopy& homotopy = sketched.curve();
  program_.emplace(system, std::move(plan));
  std::vector<double> parameters(system.parameters.size()), speeds(parameters.size());
  homotopy.path().at(t, parameters, speeds);
  start_ = PlanEvaluator(*program_).read(in_frame(system, program_->plan(), figure), parameters);
  OffsetMotion offsets = offset_motion(system, equations, homotopy);
  start_.offsets = offsets.start;
  motion_.emplace(*program_, homotopy.path(), std::move(offsets), sketched.unit());
  curve_.emplace(system, frame, equations, *motion_, start_, t);
}

}  // namespace gcslab
