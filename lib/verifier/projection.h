#pragma once

// Backward operations: what z = op(a, b) leaves of an operand.
//
// Each project_... encloses {a in within : op(a) in z}, with b in `other` where there are two operands.

#include "verifier/range.h"

namespace gcslab::verifier {

/// a * b in z.
Range project_factor(const Range& z, const Range& other, const Range& within);
/// a^2 in z.
Range project_sqr(const Range& z, const Range& within);
/// a^exponent in z.
Range project_power(const Range& z, const Rational& exponent, const Range& within);
Range project_abs(const Range& z, const Range& within);
Range project_sqrt(const Range& z, const Range& within);
Range project_sin(const Range& z, const Range& within);
Range project_cos(const Range& z, const Range& within);
Range project_tan(const Range& z, const Range& within);
Range project_asin(const Range& z, const Range& within);
Range project_acos(const Range& z, const Range& within);
Range project_atan(const Range& z, const Range& within);
/// min(a, b) in z.
Range project_min(const Range& z, const Range& other, const Range& within);

}  // namespace gcslab::verifier
