#pragma once

// Reads polynomial systems in the input format of PHCpack.
//
//   2 3                              equations, and variables if their number differs
//    x*y^2 - 1/3*z**2 + 1.5E-1;      polynomials, each ended by a semicolon, on as many lines as it takes
//    (x + y)*(z - 2)^3 - 2;
//   TITLE : ...                      what comes after the last polynomial is ignored, as PHCpack does
//
// Numbers are exact: a decimal is the rational that it spells. The imaginary unit is i or I; what remains
// imaginary in a polynomial is refused, since we solve over the reals. Variables are numbered in the order in
// which they appear, so that a line may begin with x - x + y - y to set it; terms that cancel in this way are
// left out. An exponent may be negative (Laurent systems). Comments in braces are skipped. Ways to write that
// PHCpack reads otherwise than they look (two signs in a row, x^2^3) are refused.
//
// The format has no box: every variable ranges over all reals. Names that our language forbids (x[1], sin)
// get underscores (variable_names.h).
//
// Source: J. Verschelde, Algorithm 795: PHCpack, ACM Trans. Math. Softw. 25 (1999), and its manual, "Formats
// of polynomial systems"; tried against phc 2.4.86.

#include <string>
#include <string_view>

#include "expression/equation_system.h"

namespace gcslab {

/// `file` is for messages. Throws InputError with file and line.
EquationSystem read_phc(std::string_view text, const std::string& file);

}  // namespace gcslab
