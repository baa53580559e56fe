#pragma once

// Square matrices of numbers of 256 bits: guesses, on which nothing rests, and one proof.

#include <vector>

#include "verifier/judged_system.h"

namespace gcslab::verifier {

using RealMatrix = std::vector<std::vector<Real>>;

/// The approximate inverse by Gauss and Jordan; false for a singular matrix.
bool invert(RealMatrix matrix, RealMatrix& inverse);

RealMatrix middles(const RangeMatrix& matrix);

/// True only where ||I - inverse matrix|| < 1 in the maximum norm, so that both are regular.
bool is_regular(const RealMatrix& matrix, const RealMatrix& inverse);

}  // namespace gcslab::verifier
