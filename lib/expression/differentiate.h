#pragma once

// Symbolic derivatives. abs, min and max have no derivative where they kink: the evaluator's enclosures of
// generalised derivatives serve there (tape_evaluator.h), and symbolic differentiation refuses.

#include <vector>

#include "expression/expression.h"

namespace gcslab {

/// d expression / d variable in the same graph. Throws NotApplicable for abs, min, max of what depends on the
/// variable.
Expression differentiate(Expression expression, int variable);

/// All first partial derivatives.
std::vector<Expression> gradient(Expression expression, int variables);

}  // namespace gcslab
