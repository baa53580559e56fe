#pragma once

// The equations of a constraint system in the coordinates that its frame leaves unknown.
//
// The unknowns are the variables 0 .. m-1 of the expressions, the parameters the variables after them: a
// homotopy moves the parameters, and with the values of a valuation in their place the equations are a system
// like any other.

#include <span>

#include "expression/equation_system.h"
#include "geometry/congruence.h"
#include "geometry/frame.h"

namespace gcslab {

struct GeometricEquations {
  std::shared_ptr<ExpressionGraph> graph = std::make_shared<ExpressionGraph>();
  std::vector<std::string> unknowns;  ///< P3_x, ..., and s1, ... for auxiliary ones
  std::size_t auxiliaries = 0;        ///< how many of them, the last ones
  std::vector<std::string> parameters;
  std::vector<Expression> equations;                ///< each is to vanish
  std::vector<std::size_t> constraint_of_equation;  ///< number of the constraint
  std::vector<Vector> points;                       ///< the coordinates of each, unknown or 0
};

GeometricEquations geometric_equations(const ConstraintSystem& system, const Frame& frame);

/// "12 unknowns, 12 equations: well-constrained, as far as counting tells", or by how much it is not.
std::string balance_text(const GeometricEquations& equations);

/// The equations for the values of a valuation, in a box that contains every solution: coordinates are
/// bounded where distances tie a point to the origin of the frame, and unbounded elsewhere.
EquationSystem equation_system(const GeometricEquations& equations, const ConstraintSystem& system,
                               const Frame& frame, const Valuation& valuation);

/// The figure with these values of the unknowns, auxiliary ones included.
Figure figure_at(const GeometricEquations& equations, std::span<const double> unknowns);
/// The unknowns that a figure in the frame shows; auxiliary ones are 0.
std::vector<double> unknowns_of(const GeometricEquations& equations, const Figure& figure);
/// All figures with values of the unknowns in the box.
FigureBox figure_box(const GeometricEquations& equations, const Box& unknowns);

}  // namespace gcslab
