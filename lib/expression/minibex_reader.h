#pragma once

// Reads systems in Minibex, the language of IBEX (.bch, .mbx).
//
//   Constants    n = 3;  a = 1.4;  b[2] = (1; 2);  wide in [0, 1];
//   Variables    x[n] in [-2, 2];  y in [0, pi/2];  z;                      // z ranges over all reals
//   Function     f(u, v)   s = u + v;   return s^2 - v;   end
//   Constraints
//     for i=2:n;  x(i) = y - a*x(i-1)^2;  end
//     sum(i=1:n, f(x(i), y)) = 1;
//     t = sqrt(y);  t*x(1) <= z;            // t is an abbreviation; it must be used
//     x(1) + x(2) in [0, 1];                // two inequalities
//   end
//
// Numbers are exact: 0.1 is 1/10, pi is pi, #3fb999999999999a is the double with these bits. Ends of domains
// are rounded outward once, into the box. Functions, sums and loops are written out. Entries of arrays become
// the variables x_1, x_2_3, ... row by row, with underscores added where such a name is taken.
//
// As in IBEX: x(i) counts from 1 and x[i] from 0, unless the array says its least index (x[1..n]);
// powers with fractional exponents have nonnegative bases; in "x, y in [0, 1]" only y has the domain;
// keywords may be written constants, Constants or CONSTANTS; a function sees constants and its arguments only
// and is read where it is called.
//
// Refused, with what was expected: Minimize (gcslab solves systems), < and > (their sets are not closed;
// write
// <= and >=), intervals that are not a point inside expressions (coefficients must be exact), vector-valued
// expressions, functions that we have no operation for (atan2, cosh, ...), and texts that IBEX reads
// otherwise than they look (x^-2, x^2^3, a/-b). Loops and functions that would write out more than millions
// of parts are refused too.
//
// Source: the manual of IBEX (G. Chabert and others, ibex-team.github.io/ibex-lib), "The Minibex language".

#include <string>
#include <string_view>

#include "expression/equation_system.h"

namespace gcslab {

/// `file` is for messages. Throws InputError with file and line.
EquationSystem read_minibex(std::string_view text, const std::string& file);

}  // namespace gcslab
