// Reverse operations keep every member that they must: for random members x of random sets, x stays whenever
// op(x) lies in z. The oracle for op(x) is exact (rationals) or MPFR at 300 bits, rounded outward.

#include "interval/reverse_operations.h"

#include <functional>
#include <gtest/gtest.h>
#include <numbers>
#include <string>
#include <vector>

#include "interval/elementary.h"
#include "support/fuzz.h"
#include "support/random_interval.h"

namespace gcslab {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

template <class T>
struct UnaryReverse {
  std::string name;
  std::function<MpfrInterval(const MpfrInterval&)> forward;
  std::function<T(const T& z, const T& within)> reverse;
};

template <class T>
std::vector<UnaryReverse<T>> unary_operations() {
  using Wide = const MpfrInterval&;
  std::vector<UnaryReverse<T>> result = {{"sqr", [](Wide x) { return sqr(x); }, reverse_sqr<T>},
                                         {"abs", [](Wide x) { return abs(x); }, reverse_abs<T>},
                                         {"sqrt", [](Wide x) { return sqrt(x); }, reverse_sqrt<T>},
                                         {"cbrt", [](Wide x) { return cbrt(x); }, reverse_cbrt<T>},
                                         {"exp", [](Wide x) { return exp(x); }, reverse_exp<T>},
                                         {"log", [](Wide x) { return log(x); }, reverse_log<T>},
                                         {"sin", [](Wide x) { return sin(x); }, reverse_sin<T>},
                                         {"cos", [](Wide x) { return cos(x); }, reverse_cos<T>},
                                         {"tan", [](Wide x) { return tan(x); }, reverse_tan<T>},
                                         {"asin", [](Wide x) { return asin(x); }, reverse_asin<T>},
                                         {"acos", [](Wide x) { return acos(x); }, reverse_acos<T>},
                                         {"atan", [](Wide x) { return atan(x); }, reverse_atan<T>}};
  for (const auto& [numerator, denominator] : {std::pair{3, 1},
                                               {4, 1},
                                               {7, 1},
                                               {-1, 1},
                                               {-2, 1},
                                               {-3, 1},
                                               {3, 2},
                                               {2, 3},
                                               {5, 3},
                                               {-1, 2},
                                               {-2, 3},
                                               {-1, 3}}) {
    const Rational exponent(numerator, denominator);
    result.push_back(
        {"power " + exponent.get_str(), [exponent](Wide x) { return pow(x, exponent); },
         [exponent](const T& z, const T& within) { return reverse_power<T>(z, exponent, within); }});
  }
  return result;
}

/// A set that contains `value`, an end of which it often is.
Interval random_superset(Random& random, const Interval& value) {
  Interval z = value;
  if (random.below(2) == 0) z = hull(z, random_double(random));
  if (random.below(8) == 0) z.lower = -kInfinity;
  if (random.below(8) == 0) z.upper = kInfinity;
  return z;
}

template <class T>
class ReverseOperations : public ::testing::Test {
 protected:
  static T number(const Interval& x) { return NumberTraits<T>::from_interval(x); }
  static Interval range(const T& x) { return NumberTraits<T>::enclosure(x); }
  const typename NumberTraits<T>::Scope scope_{90};
};

using Types = ::testing::Types<FastInterval, BoostInterval, MpfrInterval>;
TYPED_TEST_SUITE(ReverseOperations, Types);

TYPED_TEST(ReverseOperations, OfOneOperandKeepEveryMember) {
  Random random(fuzz_seed(), "reverse_unary");
  for (const auto& operation : unary_operations<TypeParam>()) {
    for (std::size_t i = 0; i < fuzz_cases(3000); ++i) {
      const Interval within = random_interval(random);
      const double x = random_member(random, within);
      Interval value;
      {
        const NumberTraits<MpfrInterval>::Scope scope(300);
        value = operation.forward(MpfrInterval(Interval(x))).interval();
      }
      if (is_empty(value)) continue;
      const Interval z = random_superset(random, value);
      const Interval left = this->range(operation.reverse(this->number(z), this->number(within)));
      ASSERT_TRUE(contains(left, x)) << operation.name << " of " << to_string(within) << " in "
                                     << to_string(z) << " left " << to_string(left) << " without " << x;
      ASSERT_TRUE(subset(left, within)) << operation.name;
    }
  }
}

template <class T>
struct BinaryReverse {
  std::string name;
  /// op(x, y) where x is looked for; false where it is undefined.
  std::function<bool(double x, double y, Interval& value)> forward;
  std::function<T(const T& z, const T& other, const T& within)> reverse;
};

bool quotient(double x, double y, Interval& value) {
  if (y == 0) return false;
  value = elementary::enclosing(rational_from_double(x) / rational_from_double(y));
  return true;
}

template <class T>
std::vector<BinaryReverse<T>> binary_operations() {
  return {{"multiply",
           [](double x, double y, Interval& value) {
             value = elementary::enclosing(rational_from_double(x) * rational_from_double(y));
             return true;
           },
           reverse_multiply<T>},
          {"dividend", quotient, reverse_dividend<T>},
          {"divisor", [](double x, double y, Interval& value) { return quotient(y, x, value); },
           reverse_divisor<T>},
          {"min",
           [](double x, double y, Interval& value) {
             value = std::min(x, y);
             return true;
           },
           reverse_min<T>},
          {"max",
           [](double x, double y, Interval& value) {
             value = std::max(x, y);
             return true;
           },
           reverse_max<T>}};
}

TYPED_TEST(ReverseOperations, OfTwoOperandsKeepEveryMember) {
  Random random(fuzz_seed(), "reverse_binary");
  for (const auto& operation : binary_operations<TypeParam>()) {
    for (std::size_t i = 0; i < fuzz_cases(20000); ++i) {
      const Interval within = random_interval(random);
      const Interval other = random_interval(random);
      const double x = random_member(random, within);
      const double y = random_member(random, other);
      Interval value;
      if (!operation.forward(x, y, value)) continue;
      const Interval z = random_superset(random, value);
      const Interval left =
          this->range(operation.reverse(this->number(z), this->number(other), this->number(within)));
      ASSERT_TRUE(contains(left, x)) << operation.name << " in " << to_string(z) << " with "
                                     << to_string(other) << " of " << to_string(within) << " left "
                                     << to_string(left) << " without " << x;
      ASSERT_TRUE(subset(left, within)) << operation.name;
    }
  }
}

TYPED_TEST(ReverseOperations, KnownAnswers) {
  const auto n = [](double lower, double upper) { return TestFixture::number({lower, upper}); };
  const auto near = [](const TypeParam& x, double lower, double upper) {
    const Interval found = TestFixture::range(x);
    return std::fabs(found.lower - lower) < 1e-12 && std::fabs(found.upper - upper) < 1e-12;
  };
  EXPECT_TRUE(near(reverse_sqr<TypeParam>(n(4, 9), n(-10, 10)), -3, 3));
  EXPECT_TRUE(near(reverse_sqr<TypeParam>(n(4, 9), n(-1, 10)), 2, 3));
  EXPECT_TRUE(near(reverse_multiply<TypeParam>(n(1, 2), n(-1, 1), n(0, 10)), 1, 10));
  EXPECT_TRUE(near(reverse_multiply<TypeParam>(n(6, 12), n(2, 3), n(-50, 50)), 2, 6));
  EXPECT_TRUE(near(reverse_power<TypeParam>(n(-8, 27), 3, n(-50, 50)), -2, 3));
  EXPECT_TRUE(near(reverse_power<TypeParam>(n(0.25, 4), -2, n(0, 50)), 0.5, 2));
  EXPECT_TRUE(
      near(reverse_sin<TypeParam>(n(0.5, 1), n(0, 3)), std::numbers::pi / 6, 5 * std::numbers::pi / 6));
  EXPECT_TRUE(near(reverse_cos<TypeParam>(n(-1, 0), n(5, 9)), 2.5 * std::numbers::pi, 9));
  EXPECT_TRUE(near(reverse_tan<TypeParam>(n(0, 1), n(2, 4)), std::numbers::pi, 1.25 * std::numbers::pi));
  EXPECT_TRUE(near(reverse_max<TypeParam>(n(1, 2), n(0, 5), n(-9, 9)), -9, 2));
  EXPECT_TRUE(near(reverse_max<TypeParam>(n(1, 2), n(-5, 0), n(-9, 9)), 1, 2));
}

TYPED_TEST(ReverseOperations, WhatNoMemberMeetsIsEmpty) {
  const auto n = [](double lower, double upper) { return TestFixture::number({lower, upper}); };
  const TypeParam none = TestFixture::number(Interval::empty());
  EXPECT_TRUE(is_empty(this->range(reverse_sqr<TypeParam>(n(-2, -1), n(-10, 10)))));
  EXPECT_TRUE(is_empty(this->range(reverse_multiply<TypeParam>(n(1, 2), n(0, 0), n(-10, 10)))));
  EXPECT_TRUE(is_empty(this->range(reverse_divisor<TypeParam>(n(0, 0), n(1, 2), n(-10, 10)))));
  EXPECT_TRUE(is_empty(this->range(reverse_sin<TypeParam>(n(2, 3), n(-10, 10)))));
  EXPECT_TRUE(is_empty(this->range(reverse_sin<TypeParam>(n(0.9, 1), n(-1, 1)))));
  EXPECT_TRUE(is_empty(this->range(reverse_exp<TypeParam>(n(-2, -1), n(-10, 10)))));
  EXPECT_TRUE(is_empty(this->range(reverse_sqrt<TypeParam>(n(-2, -1), n(-10, 10)))));
  EXPECT_TRUE(is_empty(this->range(reverse_min<TypeParam>(n(5, 6), n(0, 9), n(1, 2)))));
  EXPECT_TRUE(is_empty(this->range(reverse_multiply<TypeParam>(none, n(-1, 1), n(-10, 10)))));
  EXPECT_TRUE(is_empty(this->range(reverse_multiply<TypeParam>(n(-1, 1), none, n(-10, 10)))));
}

}  // namespace
}  // namespace gcslab
