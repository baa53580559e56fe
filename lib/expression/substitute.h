#pragma once

// Expressions put for the variables of another expression.

#include <span>

#include "expression/expression.h"

namespace gcslab {

/// `expression` with replacements[i], all of the graph `target`, put for variable i. The target may be
/// another graph than the expression's: with its own variables as replacements the result is a copy there,
/// which a thread may differentiate without touching a graph that others read.
Expression substitute(Expression expression, ExpressionGraph& target,
                      std::span<const Expression> replacements);

}  // namespace gcslab
