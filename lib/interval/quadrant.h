#pragma once

// Where an interval of angles lies among the multiples of pi/2, decided exactly at any size of the argument.
//
// A nonzero double or MPFR number is never a multiple of pi/2, because pi is irrational; so its quadrant
// floor(2 x / pi) is well defined and found by computing 2 x / pi in growing precision until both bounds
// agree.

#include <mpfr.h>

namespace gcslab::elementary {

struct QuadrantSpan {
  /// Quadrant of the lower end, modulo 4.
  int first = 0;
  /// Number of multiples of pi/2 in (lower, upper], counted up to 4: then a whole period is covered.
  int crossings = 0;

  /// Whether a multiple k pi/2 with k = residue modulo 4 lies in (lower, upper].
  bool crosses(int residue) const;
  /// Whether a multiple k pi/2 with odd k, a pole of the tangent, lies in (lower, upper].
  bool crosses_odd() const { return crosses(1) || crosses(3); }
};

/// The span of [lower, upper]; both ends finite, lower <= upper.
QuadrantSpan quadrant_span(double lower, double upper);
/// The same for MPFR numbers; those beyond 2^65536 are said to cover a whole period, which is safe.
QuadrantSpan quadrant_span(mpfr_srcptr lower, mpfr_srcptr upper);

}  // namespace gcslab::elementary
