// Derivatives of jets against central differences of doubles.

#include "interval/jet.h"

#include <cmath>
#include <functional>
#include <gtest/gtest.h>

namespace gcslab {
namespace {

using Pair = Jet<2>;

template <class Function>
void expect_derivatives(const char* name, const Function& f, double x, double y) {
  const Pair value = f(Pair{x, {1, 0}}, Pair{y, {0, 1}});
  constexpr double kStep = 1e-6;
  EXPECT_NEAR(value.value, f(x, y), 1e-15 * std::abs(value.value)) << name;
  EXPECT_NEAR(value.slopes[0], (f(x + kStep, y) - f(x - kStep, y)) / (2 * kStep), 1e-8) << name;
  EXPECT_NEAR(value.slopes[1], (f(x, y + kStep) - f(x, y - kStep)) / (2 * kStep), 1e-8) << name;
}

TEST(Jet, FollowsTheChainRule) {
  const double x = 0.7, y = 0.4;
  expect_derivatives(
      "sum", [](auto a, auto b) { return a + b - a * b; }, x, y);
  expect_derivatives(
      "quotient", [](auto a, auto b) { return a / b + (-a); }, x, y);
  expect_derivatives(
      "powers", [](auto a, auto b) { return sqr(a) * pow(b, 3) + pow(a, -2); }, x, y);
  expect_derivatives(
      "rational power", [](auto a, auto b) { return pow(a, Rational(2, 3)) * b; }, x, y);
  expect_derivatives(
      "roots", [](auto a, auto b) { return sqrt(a) + cbrt(b); }, x, y);
  expect_derivatives(
      "exponential", [](auto a, auto b) { return exp(a) * log(b); }, x, y);
  expect_derivatives(
      "circular", [](auto a, auto b) { return sin(a) * cos(b) + tan(a); }, x, y);
  expect_derivatives(
      "inverse", [](auto a, auto b) { return asin(a) + acos(b) * atan(a); }, x, y);
  expect_derivatives(
      "choices", [](auto a, auto b) { return abs(b - a) + min(a, b) * max(a, b); }, x, y);
}

TEST(Jet, OfAnIntegerPowerOfZeroHasItsDerivative) {
  EXPECT_EQ(pow(Pair{0, {1, 0}}, 1).slopes[0], 1);
  EXPECT_EQ(pow(Pair{0, {1, 0}}, 0).slopes[0], 0);
}

}  // namespace
}  // namespace gcslab
