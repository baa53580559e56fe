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
  Universe universe = Universe::space;
  std::vector<std::string> unknowns;  ///< P3_x, ..., l_nx, l_d, ..., and s1, ... for auxiliary ones
  std::size_t auxiliaries = 0;        ///< how many of them, the last ones
  std::vector<std::string> parameters;
  std::vector<Expression> equations;  ///< each is to vanish
  /// Number of the constraint; nothing for the last ones, by which directions have length 1 and the point of
  /// a line in space is the one nearest to the origin.
  std::vector<std::optional<std::size_t>> constraint_of_equation;
  std::vector<Sort> sorts;      ///< of the objects
  std::vector<Vector> objects;  ///< the coordinates of each, unknown or 0
};

GeometricEquations geometric_equations(const ConstraintSystem& system, const Frame& frame);

/// "12 unknowns, 12 equations: well-constrained, as far as counting tells", or by how much it is not.
std::string balance_text(const GeometricEquations& equations);

/// The equations for the values of a valuation, in a box that contains every solution: directions are in [-1,
/// 1], radii not negative, other coordinates bounded where constraints tie an object to the origin of the
/// frame (reach.h), and unbounded elsewhere.
EquationSystem equation_system(const GeometricEquations& equations, const ConstraintSystem& system,
                               const Frame& frame, const Valuation& valuation);

/// The figure with these values of the unknowns, auxiliary ones included.
Figure figure_at(const GeometricEquations& equations, std::span<const double> unknowns);
/// The unknowns that a figure in the frame shows; auxiliary ones are 0.
std::vector<double> unknowns_of(const GeometricEquations& equations, const Figure& figure);
/// All figures with values of the unknowns in the box.
FigureBox figure_box(const GeometricEquations& equations, const Box& unknowns);

}  // namespace gcslab
