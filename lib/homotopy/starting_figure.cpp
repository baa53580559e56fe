#include "homotopy/starting_figure.h"

#include "geometry/figure_projection.h"
#include "geometry/sketch.h"

namespace gcslab {

std::vector<double> drawn_unknowns(const ConstraintSystem& system, const Frame& frame,
                                   const GeometricEquations& equations, const Figure& sketch) {
  return fit_auxiliaries(system, equations, unknowns_of(equations, in_frame(system, frame, sketch))).unknowns;
}

StartingFigure starting_figure(const ConstraintSystem& system, const Frame& frame,
                               const GeometricEquations& equations, const Figure& sketch, bool as_drawn) {
  StartingFigure start{drawn_unknowns(system, frame, equations, sketch), {}};
  if (!as_drawn) {
    FigureProjection projection = satisfy_common_equations(system, equations, std::move(start.unknowns));
    if (!projection.holds) {
      const auto worst = projection.worst_constraint;
      throw NotApplicable("no figure near the sketch satisfies " +
                          (worst ? system.describe(system.constraints[*worst])
                                 : "all constraints that have no value of their own") +
                          "; draw it nearer to that");
    }
    start.unknowns = std::move(projection.unknowns);
  }
  start.parameters = parameters_of(system, figure_at(equations, start.unknowns));
  return start;
}

}  // namespace gcslab
