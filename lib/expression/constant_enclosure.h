#pragma once

// The value of an expression without variables.

#include "expression/expression.h"
#include "interval/interval.h"

namespace gcslab {

/// An interval that contains the value, computed with 128 bits and rounded outward once: almost always the
/// tightest. Empty where the expression is not defined. The expression must have no variables.
Interval constant_enclosure(Expression value);

}  // namespace gcslab
