#pragma once

// From any figure to one near by that satisfies what does not depend on the values of the parameters.

#include <optional>
#include <vector>

#include "geometry/geometric_equations.h"

namespace gcslab {

struct FigureProjection {
  std::vector<double> unknowns;
  bool holds;  ///< every equation, to about twelve digits
  /// The constraint that holds worst; nothing where it is an equation by which an object is normalised.
  std::optional<std::size_t> worst_constraint;
};

/// Moves the unknowns by Gauss and Newton's method, each step the smallest one, until the boolean constraints
/// and the normalising equations hold, and constraints that share a parameter agree on its value. Where two
/// points meet so that have a distance of their own, it begins again, and counts changes of such distances by
/// the part of them that changes: where points coincide, constraints hold that say nothing any more.
/// Auxiliary unknowns are first made those that suit best. Throws InputError where a measure is undefined.
FigureProjection satisfy_common_equations(const ConstraintSystem& system, const GeometricEquations& equations,
                                          std::vector<double> unknowns);

/// The same figure with the auxiliary unknowns that suit it best.
FigureProjection fit_auxiliaries(const ConstraintSystem& system, const GeometricEquations& equations,
                                 std::vector<double> unknowns);

}  // namespace gcslab
