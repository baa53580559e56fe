#include "interval/rounding_self_test.h"

#include <string>

#include "base/check.h"
#include "interval/boost_interval.h"
#include "interval/fast_interval.h"
#include "interval/rounding.h"

namespace gcslab {
namespace {

[[noreturn]] void report(const std::string& type, const std::string& operation) {
  throw InvariantError(
      "directed rounding does not work: " + operation + " of " + type +
      " intervals is not the tightest enclosure of the exact result; rebuild with the project's " +
      "compile options (-frounding-math, no -ffast-math), and report the compiler");
}

/// [expected, successor]: the tightest enclosure of a number between two neighbouring doubles.
void expect(const Interval& result, double lower, double upper, const char* type, const char* operation) {
  if (result.lower != lower || result.upper != upper) report(type, operation);
}

/// Operations on numbers whose exact results lie between two known doubles, on both sides of 0.
template <class T>
void check_type(const char* type) {
  const typename NumberTraits<T>::Scope scope;
  const auto number = [](double x) { return NumberTraits<T>::from_interval(opaque(x)); };
  const auto range = [](const T& x) { return NumberTraits<T>::enclosure(x); };
  constexpr double kThird = 0x1.5555555555555p-2;
  constexpr double kAboveThird = 0x1.5555555555556p-2;
  constexpr double kAboveOne = 0x1.0000000000001p0;
  constexpr double kTiny = 0x1p-80;
  expect(range(number(1) / number(3)), kThird, kAboveThird, type, "the quotient");
  expect(range(number(-1) / number(3)), -kAboveThird, -kThird, type, "the quotient");
  expect(range(number(1) + number(kTiny)), 1, kAboveOne, type, "the sum");
  expect(range(number(-1) - number(kTiny)), -kAboveOne, -1, type, "the difference");
  expect(range(number(kAboveOne) * number(kAboveOne)), 0x1.0000000000002p0, 0x1.0000000000003p0, type,
         "the product");
  expect(range(number(-kAboveOne) * number(kAboveOne)), -0x1.0000000000003p0, -0x1.0000000000002p0, type,
         "the product");
  expect(range(sqr(number(kAboveOne))), 0x1.0000000000002p0, 0x1.0000000000003p0, type, "the square");
  expect(range(sqrt(number(2))), 0x1.6a09e667f3bccp0, 0x1.6a09e667f3bcdp0, type, "the square root");
  expect(range(number(0x1p-1074) * number(0.5)), 0, 0x1p-1074, type, "the subnormal product");
  expect(range(number(4) / number(2)), 2, 2, type, "the exact quotient");
}

}  // namespace

void check_rounding() {
  const RoundingMode before = rounding_mode();
  check_type<FastInterval>("fast");
  check_type<BoostInterval>("boost");
  if (rounding_mode() != before) {
    throw InvariantError("directed rounding does not work: a rounding scope did not restore the mode");
  }
}

}  // namespace gcslab
