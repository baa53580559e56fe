#pragma once

// Set operations and reverse operations for every interval type, as constraint propagation needs them.
//
// A reverse operation solves op(x) = z for x: it encloses {x in within : op(x) in z} (the unary ...Rev and
// the binary mulRev functions of IEEE 1788-2015, section 10.5.4; Benhamou, Goualard, Granvilliers, Puget
// 1999, "Revising hull and box consistency"). A NumberTraits<T>::Scope must be alive. For the unrounded
// baseline nothing is promised.

#include "interval/boost_interval.h"
#include "interval/fast_interval.h"
#include "interval/mpfr_interval.h"
#include "interval/number_traits.h"
#include "interval/unrounded_interval.h"

namespace gcslab {

// FastInterval has its own.
BoostInterval intersection(const BoostInterval& x, const BoostInterval& y);
MpfrInterval intersection(const MpfrInterval& x, const MpfrInterval& y);
UnroundedInterval intersection(const UnroundedInterval& x, const UnroundedInterval& y);
BoostInterval hull(const BoostInterval& x, const BoostInterval& y);
MpfrInterval hull(const MpfrInterval& x, const MpfrInterval& y);
UnroundedInterval hull(const UnroundedInterval& x, const UnroundedInterval& y);

/// {x in within : b x in product for some b in factor}.
template <SetNumber T>
T reverse_multiply(const T& product, const T& factor, const T& within);
/// {x in within : x / b in quotient for some b in divisor, b not 0}; the divisor's side is reverse_divisor.
template <SetNumber T>
T reverse_dividend(const T& quotient, const T& divisor, const T& within);
/// {x in within, not 0 : a / x in quotient for some a in dividend}.
template <SetNumber T>
T reverse_divisor(const T& quotient, const T& dividend, const T& within);

template <SetNumber T>
T reverse_sqr(const T& z, const T& within);
template <SetNumber T>
T reverse_power(const T& z, const Rational& exponent, const T& within);
template <SetNumber T>
T reverse_abs(const T& z, const T& within);
template <SetNumber T>
T reverse_sqrt(const T& z, const T& within);
template <SetNumber T>
T reverse_cbrt(const T& z, const T& within);
template <SetNumber T>
T reverse_exp(const T& z, const T& within);
template <SetNumber T>
T reverse_log(const T& z, const T& within);
template <SetNumber T>
T reverse_sin(const T& z, const T& within);
template <SetNumber T>
T reverse_cos(const T& z, const T& within);
template <SetNumber T>
T reverse_tan(const T& z, const T& within);
template <SetNumber T>
T reverse_asin(const T& z, const T& within);
template <SetNumber T>
T reverse_acos(const T& z, const T& within);
template <SetNumber T>
T reverse_atan(const T& z, const T& within);
/// {x in within : min(x, y) in z for some y in other}.
template <SetNumber T>
T reverse_min(const T& z, const T& other, const T& within);
/// {x in within : max(x, y) in z for some y in other}.
template <SetNumber T>
T reverse_max(const T& z, const T& other, const T& within);

}  // namespace gcslab
