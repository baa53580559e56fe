#pragma once

// The choice of an interval arithmetic by name, where a method has the option `arithmetic`.

#include <array>
#include <string_view>
#include <type_traits>
#include <utility>

#include "interval/boost_interval.h"
#include "interval/fast_interval.h"
#include "interval/mpfr_interval.h"
#include "interval/unrounded_interval.h"

namespace gcslab {

enum class Arithmetic {
  fast,      ///< FastInterval
  boost,     ///< BoostInterval
  mpfr,      ///< MpfrInterval
  unrounded  ///< UnroundedInterval, a baseline
};

inline constexpr std::array kArithmetics = {Arithmetic::fast, Arithmetic::boost, Arithmetic::mpfr,
                                            Arithmetic::unrounded};

std::string_view name_of(Arithmetic arithmetic);
/// One sentence for help texts.
std::string_view description_of(Arithmetic arithmetic);
/// The inverse of name_of. Throws InputError for a word that names no arithmetic.
Arithmetic arithmetic_from_name(std::string_view name);
Promise promise_of(Arithmetic arithmetic);

/// f(std::type_identity<T>{}) for the number type T that the arithmetic names; f returns the same type for
/// all.
template <class F>
decltype(auto) with_arithmetic(Arithmetic arithmetic, F&& f) {
  switch (arithmetic) {
    case Arithmetic::boost:
      return std::forward<F>(f)(std::type_identity<BoostInterval>{});
    case Arithmetic::mpfr:
      return std::forward<F>(f)(std::type_identity<MpfrInterval>{});
    case Arithmetic::unrounded:
      return std::forward<F>(f)(std::type_identity<UnroundedInterval>{});
    case Arithmetic::fast:
      break;
  }
  return std::forward<F>(f)(std::type_identity<FastInterval>{});
}

}  // namespace gcslab
