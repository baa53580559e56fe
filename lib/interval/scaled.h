#pragma once

// Products of a set and one number.

#include "interval/fast_interval.h"
#include "interval/number_traits.h"

namespace gcslab {

/// multiplier * x for a finite multiplier other than 0. A NumberTraits<T>::Scope must be alive.
inline FastInterval scaled(double multiplier, FastInterval x) {
  const __m128d ends = multiplier < 0 ? fast_detail::swapped(x.raw()) : x.raw();
  const double size = multiplier < 0 ? -multiplier : multiplier;
  return FastInterval::from_raw(opaque(_mm_mul_pd(opaque(ends), _mm_set1_pd(size))));
}
template <class T>
T scaled(double multiplier, const T& x) {
  return NumberTraits<T>::from_interval(Interval(multiplier)) * x;
}

}  // namespace gcslab
