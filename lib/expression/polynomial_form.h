#pragma once

// Whether expressions are written as polynomials, for languages that have nothing else.

#include <string_view>

#include "expression/equation_system.h"

namespace gcslab {

/// Which constants a language has besides rational numbers.
enum class Constants { rational, rational_and_pi };

/// Passes when every equation is built from variables and constants by + - * and natural powers, and by
/// division by constants. Throws NotApplicable that names the language, the equation and what is in the way.
void require_polynomial_form(const EquationSystem& system, Constants constants, std::string_view language);

}  // namespace gcslab
