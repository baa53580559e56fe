#pragma once

// From a sketch to a point where a path can start.

#include <vector>

#include "geometry/geometric_equations.h"

namespace gcslab {

/// The start of a homotopy: the unknowns, and the parameters that the figure shows.
struct StartingFigure {
  std::vector<double> unknowns;
  std::vector<double> parameters;
};

/// Moves the sketch into the frame and, by Gauss and Newton's method, to a figure near by on which the
/// boolean constraints hold: a sketch of a quadrilateral is seldom flat to the last digit. Throws
/// NotApplicable, with the constraint that holds worst, when none is found; InputError where the sketch has
/// no frame or a measure is undefined.
StartingFigure starting_figure(const ConstraintSystem& system, const Frame& frame,
                               const GeometricEquations& equations, const Figure& sketch);

}  // namespace gcslab
