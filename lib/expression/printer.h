#pragma once

// Expressions as text that parses back to the same node, and as LaTeX.

#include <span>
#include <string>

#include "expression/expression.h"

namespace gcslab {

/// Text in the language of parser.h with the fewest parentheses; parsing it gives `expression` again.
std::string to_text(Expression expression, std::span<const std::string> variables);

/// LaTeX for display mathematics, without delimiters.
std::string to_latex(Expression expression, std::span<const std::string> variables);

}  // namespace gcslab
