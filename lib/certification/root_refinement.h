#pragma once

// Certified roots to any number of digits.

#include <vector>

#include "certification/root_certificate.h"
#include "certification/system_functions.h"
#include "interval/mpfr_interval.h"

namespace gcslab {

struct RefinedRoot {
  std::vector<MpfrInterval> box;  ///< contains the root, one interval a variable
  int bits;                       ///< precision of its ends
  bool reached;                   ///< each side is as narrow as 2^-wanted of its magnitude (of 1 below 1)
};

/// Narrows the box of a certified root by Krawczyk's operator in MPFR intervals until its sides are 2^-bits
/// of their magnitudes, as far as the equations allow. Every step keeps the root.
RefinedRoot refine_root(const SystemFunctions& functions, const CertifiedRoot& root, int bits);

/// The middle of the interval to `digits` significant decimal digits.
std::string decimal_text(const MpfrInterval& x, int digits);

}  // namespace gcslab
