#include "construction/plan_homotopy.h"

#include <utility>

namespace gcslab {

PlanHomotopy::PlanHomotopy(const ConstraintSystem& system, const Frame& frame,
                           const GeometricEquations& equations, const SketchHomotopy& sketched,
                           PlanKind kind) {
  const Homotopy& homotopy = sketched.curve();
  const Figure figure = figure_at(equations, homotopy.unknowns(sketched.start()));
  program_.emplace(system, make_plan(system, kind, figure));
  std::vector<double> parameters(system.parameters.size()), speeds(parameters.size());
  homotopy.path().at(0, parameters, speeds);
  start_ = PlanEvaluator(*program_).read(in_frame(system, program_->plan(), figure), parameters);
  // Constraints that do not move hold all along, and what was read of them are rounding errors.
  const std::vector<double> read = std::exchange(start_.offsets, std::vector(start_.offsets.size(), 0.0));
  std::vector<double> leading(read.size(), 0.0);
  for (const EquationOffset& offset : homotopy.offsets()) {
    const std::optional<std::size_t> constraint = equations.constraint_of_equation[offset.equation];
    if (!constraint) continue;
    start_.offsets[*constraint] = read[*constraint];
    leading[*constraint] = offset.leading / homotopy.weights()[offset.equation];
  }
  motion_.emplace(*program_, homotopy.path(), OffsetMotion{start_.offsets, std::move(leading)},
                  sketched.unit());
  curve_.emplace(system, frame, equations, *motion_, start_);
}

}  // namespace gcslab
