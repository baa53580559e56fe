#include "construction/plan_homotopy.h"

namespace gcslab {

PlanHomotopy::PlanHomotopy(const ConstraintSystem& system, const Frame& frame,
                           const GeometricEquations& equations, const SketchHomotopy& sketched,
                           PlanKind kind) {
  const Homotopy& homotopy = sketched.curve();
  const Figure figure = figure_at(equations, homotopy.unknowns(sketched.start()));
  program_.emplace(system, make_plan(system, kind, figure));
  std::vector<double> parameters(system.parameters.size()), speeds(parameters.size());
  homotopy.path().at(0, parameters, speeds);
  PlanValues start = PlanEvaluator(*program_).read(in_frame(system, program_->plan(), figure), parameters);
  std::vector<double> leading(start.offsets.size(), 0.0);
  std::vector<bool> moves(start.offsets.size(), false);
  for (const EquationOffset& offset : homotopy.offsets()) {
    const std::optional<std::size_t> constraint = equations.constraint_of_equation[offset.equation];
    if (!constraint) continue;
    moves[*constraint] = true;
    leading[*constraint] = offset.leading / homotopy.weights()[offset.equation];
  }
  for (std::size_t c = 0; c < moves.size(); ++c) {
    if (!moves[c]) start.offsets[c] = 0;  // rounding errors
  }
  curve_.emplace(system, frame, equations, *program_, homotopy.path(), start, std::move(leading),
                 sketched.unit());
}

}  // namespace gcslab
