#pragma once

// Writes polynomial systems as input files of Bertini.
//
//   CONFIG ... END; INPUT variable_group x, y; function f1, f2; f1 = ...; END;
//
// All variables are one affine group and the configuration is Bertini's default: a zero-dimensional run.
// Coefficients are exact rationals, pi is Pi. Box and inequalities have no place in the file; comments (%) at
// its top say so and tell new names: names that Bertini reserves, and those that begin with an underscore,
// get v_ in front.
//
// Source: D. Bates, J. Hauenstein, A. Sommese, C. Wampler, Numerically Solving Polynomial Systems with
// Bertini (2013), and the Bertini user's manual, "Syntax for input files".

#include <string>

#include "expression/equation_system.h"

namespace gcslab {

/// Throws NotApplicable, with the reason, for equations that are no polynomials.
std::string write_bertini(const EquationSystem& system);

}  // namespace gcslab
