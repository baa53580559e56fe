#pragma once

// Elementary functions of one double as an unevaluated sum of two, with a proved error bound near 2^-60 of
// the value: in all but about one case in a hundred that settles the correctly rounded result (Ziv 1991,
// "Fast evaluation of elementary mathematical functions with correctly rounded last bit"), at a tenth of
// MPFR's cost or less; elementary.cpp asks MPFR for the rest. The proofs, beside each function, take 2^-52 as
// the error of one operation, so that they hold in every rounding mode. Tables are computed by MPFR at first
// use: no constant is transcribed, and libm is not used.

namespace gcslab::elementary {

/// |f(x) - (high + low)| <= error, when `known`; otherwise nothing is claimed (argument out of the method's
/// range).
struct AccurateValue {
  bool known = false;
  double high = 0;
  double low = 0;
  double error = 0;
};

using AccurateFunction = AccurateValue (*)(double x);

AccurateValue accurate_exp(double x);
AccurateValue accurate_log(double x);
AccurateValue accurate_sin(double x);
AccurateValue accurate_cos(double x);
AccurateValue accurate_tan(double x);
AccurateValue accurate_atan(double x);

}  // namespace gcslab::elementary
