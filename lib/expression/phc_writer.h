#pragma once

// Writes polynomial systems in the input format of PHCpack (phc_reader.h).
//
// The equations are written as they stand, with exact coefficients: rational numbers are (1/3), integers of
// more than 17 digits 1.234E+20, all digits written (phc 2.4.86 cuts integers off after 18). read_phc gives
// the same functions of the same variables in the same order.
//
// Numbers behind a parenthesis are in parentheses, powers are ^: phc 2.4.86 does not read (x + y)*3 and
// (x + y)**2*z. It does misread a factor that cancels to zero, as in x*(y - y): expand such a system first.
//
// PHCpack solves over the complex numbers: box and inequalities have no place in the file. A note after the
// polynomials, where PHCpack does not read, says so, and tells new names: names that begin with e, E, i or I
// could be taken for exponents and the imaginary unit and get v_ in front.

#include <string>

#include "expression/equation_system.h"

namespace gcslab {

/// Throws NotApplicable, with the reason, for equations that are no polynomials with rational coefficients.
std::string write_phc(const EquationSystem& system);

}  // namespace gcslab
