#pragma once

// Whether constraints and unknowns balance: by counting, by structure, and by rank at a figure.
//
// Structure is which unknowns occur in which equation; it cannot see that the equations of a redundant
// constraint depend on others. The rank of the Jacobian at a generic figure on which the boolean constraints
// hold, a witness, can (Michelucci, Foufou 2006): it is that of almost every figure near by, in the same
// component of those figures.

#include <optional>
#include <string>
#include <vector>

#include "geometry/geometric_equations.h"

namespace gcslab {

/// Numbers of constraints and objects, ascending. Neither list has members when all is well-constrained.
struct StructuralDiagnosis {
  std::size_t rank = 0;            ///< equations that can be matched with an unknown each
  std::vector<std::size_t> over;   ///< constraints of the over-constrained part
  std::vector<std::size_t> under;  ///< objects of the under-constrained part
};

StructuralDiagnosis structural_diagnosis(const GeometricEquations& equations);

struct WitnessDiagnosis {
  std::size_t rank = 0;                ///< of the Jacobian, to a tolerance
  std::vector<std::size_t> redundant;  ///< constraints with an equation that depends on other equations
  std::vector<std::size_t> movable;    ///< objects that can move although every constraint holds
};

/// At the sketch moved a little at random, or at random figures, on which constraints that share a parameter
/// agree; of several the one of highest rank. Nothing when no such figure was found. Figures are drawn by
/// seeds of their own, the same at each call.
std::optional<WitnessDiagnosis> witness_diagnosis(const ConstraintSystem& system, const Frame& frame,
                                                  const GeometricEquations& equations);

/// "over-constrained: constraint 1, distance A B; ...", "under-constrained: C, D", both, or "no part is over-
/// or under-constrained".
std::string structure_text(const ConstraintSystem& system, const StructuralDiagnosis& diagnosis);

/// "rank 17 of 18 equations in 18 unknowns at a witness; redundant, each given the others: ...; movable:
/// ...".
std::string witness_text(const ConstraintSystem& system, const GeometricEquations& equations,
                         const WitnessDiagnosis& diagnosis);

}  // namespace gcslab
