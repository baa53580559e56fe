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

/// The unknowns that the sketch shows, moved into the frame but otherwise as drawn; auxiliary ones are those
/// that fit it best. Throws InputError where the sketch has no frame.
std::vector<double> drawn_unknowns(const ConstraintSystem& system, const Frame& frame,
                                   const GeometricEquations& equations, const Figure& sketch);

/// Moves the sketch into the frame and, by Gauss and Newton's method, to a figure near by on which the
/// boolean constraints hold and constraints that share a parameter agree: a sketch of a quadrilateral is
/// seldom flat to the last digit. Throws
/// NotApplicable, with the constraint that holds worst, when none is found; InputError where the sketch has
/// no frame or a measure is undefined. With `as_drawn`, the figure is the sketch itself.
StartingFigure starting_figure(const ConstraintSystem& system, const Frame& frame,
                               const GeometricEquations& equations, const Figure& sketch,
                               bool as_drawn = false);

}  // namespace gcslab
