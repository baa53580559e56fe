#pragma once

// Elementary functions of intervals, proved enclosing: each end is computed by MPFR, whose functions are
// correctly rounded (Fousse et al. 2007, "MPFR: a multiple-precision binary floating-point library with
// correct rounding").
//
// Each function gives the tightest interval of doubles that contains {f(a) : a in x, f defined at a}: the
// natural interval extension of IEEE 1788-2015. That holds at huge arguments too: which extrema and poles of
// the circular functions lie in x is decided exactly. The results do not depend on the rounding mode of the
// caller, nor on libm.

#include "interval/interval.h"
#include "interval/rational.h"

namespace gcslab::elementary {

/// How the ends of a result are rounded. Only `outward` encloses; `to_nearest` is there for the unrounded
/// baseline.
enum class Ends { outward, to_nearest };

Interval sqrt(const Interval& x, Ends ends = Ends::outward);
Interval cbrt(const Interval& x, Ends ends = Ends::outward);
Interval exp(const Interval& x, Ends ends = Ends::outward);
Interval log(const Interval& x, Ends ends = Ends::outward);
Interval sin(const Interval& x, Ends ends = Ends::outward);
Interval cos(const Interval& x, Ends ends = Ends::outward);
Interval tan(const Interval& x, Ends ends = Ends::outward);
Interval asin(const Interval& x, Ends ends = Ends::outward);
Interval acos(const Interval& x, Ends ends = Ends::outward);
Interval atan(const Interval& x, Ends ends = Ends::outward);

/// x^(p/q) in lowest terms. Odd q: the real odd root, defined on all reals (0 excepted when p < 0). Even q:
/// defined for nonnegative numbers. Exponent 0: 1 everywhere. Encloses for all exponents; tightest when q = 1
/// and |p| < 2^31.
Interval pow(const Interval& x, const Rational& exponent, Ends ends = Ends::outward);

/// The tightest interval of doubles around a rational number.
Interval enclosing(const Rational& value, Ends ends = Ends::outward);
Interval pi(Ends ends = Ends::outward);

}  // namespace gcslab::elementary
