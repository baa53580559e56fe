#pragma once

// Writes systems as JSON, exactly:
//
//   {
//     "format": "gcslab-system",
//     "variables": ["x", "y"],
//     "equations": ["x^2 + y^2 - 1"],           each is to vanish
//     "inequalities": ["x - 1/2"],              each is to be <= 0
//     "box": {"x": ["-0x1p+1", "0x1.8p+0"], "y": ["-inf", "inf"]}
//   }
//
// Expressions are in the language of parser.h and parse back to the same expressions; ends of the box are
// hexadecimal floating-point numbers, as strtod reads them.

#include <string>

#include "expression/equation_system.h"

namespace gcslab {

/// Throws NotApplicable when an expression is too long to be written (notation.h).
std::string write_json(const EquationSystem& system);

}  // namespace gcslab
