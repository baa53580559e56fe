#include "interval/arithmetic.h"

#include <string>
#include <vector>

#include "base/error.h"
#include "base/nearest_name.h"

namespace gcslab {

std::string_view name_of(Arithmetic arithmetic) {
  switch (arithmetic) {
    case Arithmetic::fast:
      return "fast";
    case Arithmetic::boost:
      return "boost";
    case Arithmetic::mpfr:
      return "mpfr";
    case Arithmetic::unrounded:
      break;
  }
  return "unrounded";
}

std::string_view description_of(Arithmetic arithmetic) {
  switch (arithmetic) {
    case Arithmetic::fast:
      return "double intervals stored as (-lower, upper), rounded outward under one rounding mode";
    case Arithmetic::boost:
      return "double intervals of Boost.Interval, rounded outward";
    case Arithmetic::mpfr:
      return "intervals of MPFR numbers of any precision, rounded outward";
    case Arithmetic::unrounded:
      break;
  }
  return "baseline: double intervals rounded to nearest, which may miss the true value";
}

Arithmetic arithmetic_from_name(std::string_view name) {
  std::vector<std::string> known;
  for (const Arithmetic arithmetic : kArithmetics) {
    if (name == name_of(arithmetic)) return arithmetic;
    known.emplace_back(name_of(arithmetic));
  }
  throw InputError(unknown_name_message("arithmetic", name, known));
}

Promise promise_of(Arithmetic arithmetic) {
  return with_arithmetic(arithmetic, []<class T>(std::type_identity<T>) { return NumberTraits<T>::promise; });
}

}  // namespace gcslab
