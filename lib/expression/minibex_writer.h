#pragma once

// Writes systems in Minibex, the language of IBEX (minibex_reader.h).
//
// read_minibex gives the same functions, inequalities and box. Rational constants are written p/q; ends of
// the box exactly: as short decimals where there are some, as p/2^k or p*2^k otherwise. Real odd roots, which
// Minibex defines for nonnegative numbers only, are written max(x, 0)^(1/3) - max(-x, 0)^(1/3), and
// abs(x)^(2/3). Names that Minibex reserves get v_ in front; comments tell them.

#include <string>

#include "expression/equation_system.h"

namespace gcslab {

/// Throws NotApplicable when an expression is too long to be written (notation.h).
std::string write_minibex(const EquationSystem& system);

}  // namespace gcslab
