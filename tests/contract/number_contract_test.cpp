// What every set-valued number type owes its users (number_traits.h): algebra, inclusion isotonicity, natural
// domains, empty and unbounded operands, and scopes that leave the thread's rounding mode as they found it.
// What holds of every type that encloses is tested on the rigorous ones alone.

#include <functional>
#include <gtest/gtest.h>
#include <limits>
#include <string>
#include <vector>

#include "interval/affine_form.h"
#include "interval/boost_interval.h"
#include "interval/fast_interval.h"
#include "interval/mpfr_interval.h"
#include "interval/unrounded_interval.h"
#include "support/fuzz.h"
#include "support/random_interval.h"

namespace gcslab {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

template <class T>
class NumberContract : public ::testing::Test {
 protected:
  using Traits = NumberTraits<T>;

  static T make(double lower, double upper) { return Traits::from_interval({lower, upper}); }
  static T make(double point) { return Traits::from_interval(point); }
  static T make(const Interval& x) { return Traits::from_interval(x); }
  static Interval range(const T& x) { return Traits::enclosure(x); }

  const typename Traits::Scope scope_;
};

using SetTypes = ::testing::Types<FastInterval, BoostInterval, MpfrInterval, UnroundedInterval,
                                  ChebyshevAffine, MinRangeAffine>;
TYPED_TEST_SUITE(NumberContract, SetTypes);

template <class T>
struct NamedFunction {
  std::string name;
  std::function<T(const T&)> apply;
};

template <class T>
std::vector<NamedFunction<T>> unary_functions() {
  return {{"negate", [](const T& x) { return -x; }},
          {"sqr", [](const T& x) { return sqr(x); }},
          {"cube", [](const T& x) { return pow(x, 3); }},
          {"x^4", [](const T& x) { return pow(x, 4); }},
          {"x^-1", [](const T& x) { return pow(x, -1); }},
          {"x^-2", [](const T& x) { return pow(x, -2); }},
          {"x^(2/3)", [](const T& x) { return pow(x, Rational(2, 3)); }},
          {"x^(-1/2)", [](const T& x) { return pow(x, Rational(-1, 2)); }},
          {"sqrt", [](const T& x) { return sqrt(x); }},
          {"cbrt", [](const T& x) { return cbrt(x); }},
          {"exp", [](const T& x) { return exp(x); }},
          {"log", [](const T& x) { return log(x); }},
          {"sin", [](const T& x) { return sin(x); }},
          {"cos", [](const T& x) { return cos(x); }},
          {"tan", [](const T& x) { return tan(x); }},
          {"asin", [](const T& x) { return asin(x); }},
          {"acos", [](const T& x) { return acos(x); }},
          {"atan", [](const T& x) { return atan(x); }},
          {"abs", [](const T& x) { return abs(x); }}};
}

template <class T>
struct NamedOperation {
  std::string name;
  std::function<T(const T&, const T&)> apply;
};

template <class T>
std::vector<NamedOperation<T>> binary_operations() {
  return {{"+", [](const T& x, const T& y) { return x + y; }},
          {"-", [](const T& x, const T& y) { return x - y; }},
          {"*", [](const T& x, const T& y) { return x * y; }},
          {"/", [](const T& x, const T& y) { return x / y; }},
          {"min", [](const T& x, const T& y) { return min(x, y); }},
          {"max", [](const T& x, const T& y) { return max(x, y); }}};
}

TYPED_TEST(NumberContract, TraitsEncloseWhatTheyAreGiven) {
  EXPECT_EQ(this->range(this->make(-1, 2)), Interval(-1, 2));
  EXPECT_EQ(this->range(this->make(Interval::empty())), Interval::empty());
  EXPECT_EQ(this->range(this->make(Interval::entire())), Interval::entire());
  EXPECT_EQ(this->range(this->make(0, kInfinity)), Interval(0, kInfinity));
  EXPECT_EQ(this->range(NumberTraits<TypeParam>::from_rational(Rational(3, 4))), Interval(0.75));
  const Interval pi = this->range(NumberTraits<TypeParam>::pi());
  EXPECT_NEAR(pi.lower, 3.141592653589793, 1e-15);
  EXPECT_NEAR(pi.upper, 3.141592653589793, 1e-15);
  EXPECT_TRUE(NumberTraits<TypeParam>::is_set);
}

TYPED_TEST(NumberContract, AScopeRestoresTheRoundingMode) {
  const RoundingMode outside = rounding_mode();
  {
    const typename NumberTraits<TypeParam>::Scope inner(80);
    exp(this->make(1, 2)) + sin(this->make(1, 2));
  }
  EXPECT_EQ(rounding_mode(), outside);
  const NearestRounding nearest;
  { const typename NumberTraits<TypeParam>::Scope inner; }
  EXPECT_TRUE(rounding_is_nearest());
}

TYPED_TEST(NumberContract, EmptyOperandsGiveEmptyResults) {
  const TypeParam empty = this->make(Interval::empty());
  for (const auto& function : unary_functions<TypeParam>()) {
    EXPECT_TRUE(is_empty(this->range(function.apply(empty)))) << function.name;
  }
  for (const Interval& other : {Interval(1, 2), Interval(0), Interval(-1, kInfinity), Interval::entire()}) {
    for (const auto& operation : binary_operations<TypeParam>()) {
      EXPECT_TRUE(is_empty(this->range(operation.apply(empty, this->make(other))))) << operation.name;
      EXPECT_TRUE(is_empty(this->range(operation.apply(this->make(other), empty)))) << operation.name;
    }
  }
  EXPECT_TRUE(is_empty(this->range(pow(empty, 0))));
  EXPECT_TRUE(is_empty(this->range(sign_enclosure(empty))));
  EXPECT_TRUE(is_empty(this->range(less_enclosure(empty, this->make(1)))));
}

TYPED_TEST(NumberContract, OperandsOutsideTheDomainGiveEmptyResults) {
  EXPECT_TRUE(is_empty(this->range(sqrt(this->make(-2, -1)))));
  EXPECT_TRUE(is_empty(this->range(log(this->make(-2, 0)))));
  EXPECT_TRUE(is_empty(this->range(asin(this->make(2, 3)))));
  EXPECT_TRUE(is_empty(this->range(acos(this->make(-3, -2)))));
  EXPECT_TRUE(is_empty(this->range(this->make(1, 2) / this->make(0))));
  EXPECT_TRUE(is_empty(this->range(pow(this->make(0), -2))));
  EXPECT_TRUE(is_empty(this->range(pow(this->make(-2, -1), Rational(3, 2)))));
}

TYPED_TEST(NumberContract, OperandsPartlyOutsideAreCutToTheDomain) {
  EXPECT_EQ(this->range(sqrt(this->make(-9, 4))), Interval(0, 2));
  EXPECT_EQ(this->range(log(this->make(-1, 1))), Interval(-kInfinity, 0));
  EXPECT_EQ(this->range(acos(this->make(1, 5))), Interval(0));
  EXPECT_EQ(this->range(pow(this->make(-9, 4), Rational(1, 2))), Interval(0, 2));
}

TYPED_TEST(NumberContract, QuotientsFollowTheSignsOfTheDivisor) {
  const auto quotient = [this](const Interval& x, const Interval& y) {
    return this->range(this->make(x) / this->make(y));
  };
  EXPECT_EQ(quotient({1, 2}, {-1, 1}), Interval::entire());
  EXPECT_EQ(quotient({1, 2}, {0, 4}), Interval(0.25, kInfinity));
  EXPECT_EQ(quotient({1, 2}, {-4, 0}), Interval(-kInfinity, -0.25));
  EXPECT_EQ(quotient({-1, 2}, {0, 4}), Interval::entire());
  EXPECT_EQ(quotient({-2, 0}, {0, 1}), Interval(-kInfinity, 0));
  EXPECT_EQ(quotient(0, {-1, 1}), Interval(0));
  EXPECT_EQ(quotient({1, 2}, {4, kInfinity}), Interval(0, 0.5));
  EXPECT_EQ(quotient({1, kInfinity}, {1, kInfinity}), Interval(0, kInfinity));
}

TYPED_TEST(NumberContract, UnboundedOperandsHaveNoNaN) {
  EXPECT_EQ(this->range(this->make(0) * this->make(Interval::entire())), Interval(0));
  EXPECT_EQ(this->range(this->make(0, 1) * this->make(1, kInfinity)), Interval(0, kInfinity));
  EXPECT_EQ(this->range(this->make(0, kInfinity) - this->make(0, kInfinity)), Interval::entire());
  EXPECT_EQ(this->range(pow(this->make(-kInfinity, 2), 2)), Interval(0, kInfinity));
  EXPECT_EQ(this->range(pow(this->make(-kInfinity, 2), 3)), Interval(-kInfinity, 8));
  EXPECT_EQ(this->range(pow(this->make(2, kInfinity), -1)), Interval(0, 0.5));
  EXPECT_EQ(this->range(exp(this->make(-kInfinity, 0))), Interval(0, 1));
  EXPECT_EQ(this->range(sin(this->make(0, kInfinity))), Interval(-1, 1));
  EXPECT_EQ(this->range(tan(this->make(1, 2))), Interval::entire());
  EXPECT_EQ(this->range(abs(this->make(-kInfinity, 2))), Interval(0, kInfinity));
}

TYPED_TEST(NumberContract, EvenPowersAreSharperThanProducts) {
  EXPECT_EQ(this->range(sqr(this->make(-1, 2))), Interval(0, 4));
  EXPECT_EQ(this->range(pow(this->make(-2, 1), 4)), Interval(0, 16));
  EXPECT_EQ(this->range(pow(this->make(-2, 1), 3)), Interval(-8, 1));
  EXPECT_EQ(this->range(pow(this->make(-2, -1), -2)), Interval(0.25, 1));
  EXPECT_EQ(this->range(pow(this->make(-2, 1), -2)), Interval(0.25, kInfinity));
  EXPECT_EQ(this->range(pow(this->make(-2, 1), 0)), Interval(1));
}

/// Without dependency x * x is the product of two independent intervals (Tahari 2011, section 2.2).
template <class T>
class NaturalContract : public NumberContract<T> {};

using NaturalTypes = ::testing::Types<FastInterval, BoostInterval, MpfrInterval, UnroundedInterval>;
TYPED_TEST_SUITE(NaturalContract, NaturalTypes);

TYPED_TEST(NaturalContract, ProductsForgetThatTheirFactorsAreEqual) {
  const TypeParam x = this->make(-1, 2);
  EXPECT_EQ(this->range(x * x), Interval(-2, 4));
  EXPECT_EQ(this->range(x - x), Interval(-3, 3));
  const TypeParam y = this->make(1, 2);
  EXPECT_EQ(this->range(y / y), Interval(0.5, 2));
}

TYPED_TEST(NaturalContract, MultiplicationIsOnlySubdistributive) {
  const TypeParam x = this->make(-1, 1);
  const TypeParam y = this->make(1, 2);
  const TypeParam z = this->make(-2, -1);
  EXPECT_EQ(this->range(x * (y + z)), Interval(-1, 1));
  EXPECT_EQ(this->range(x * y + x * z), Interval(-4, 4));
}

TYPED_TEST(NaturalContract, OperationsCommuteAndHaveNeutralElements) {
  Random random(fuzz_seed(), "commute");
  for (std::size_t i = fuzz_cases(2000); i > 0; --i) {
    const TypeParam x = this->make(random_interval(random));
    const TypeParam y = this->make(random_interval(random));
    ASSERT_EQ(this->range(x + y), this->range(y + x));
    ASSERT_EQ(this->range(x * y), this->range(y * x));
    ASSERT_EQ(this->range(min(x, y)), this->range(min(y, x)));
    ASSERT_EQ(this->range(x + this->make(0)), this->range(x));
    ASSERT_EQ(this->range(x * this->make(1)), this->range(x));
    ASSERT_EQ(this->range(-(-x)), this->range(x));
    ASSERT_EQ(this->range(x - y), this->range(-(y - x)));
    ASSERT_EQ(this->range(max(x, y)), this->range(-min(-x, -y)));
  }
}

TYPED_TEST(NumberContract, MinMaxAndAbs) {
  EXPECT_EQ(this->range(min(this->make(-1, 4), this->make(2, 3))), Interval(-1, 3));
  EXPECT_EQ(this->range(max(this->make(-1, 4), this->make(2, 3))), Interval(2, 4));
  EXPECT_EQ(this->range(min(this->make(-1, 1), this->make(2, 3))), Interval(-1, 1));
  EXPECT_EQ(this->range(abs(this->make(-3, -1))), Interval(1, 3));
  EXPECT_EQ(this->range(abs(this->make(-3, 1))), Interval(0, 3));
}

TYPED_TEST(NumberContract, DerivativesOfPiecewiseFunctions) {
  EXPECT_EQ(this->range(sign_enclosure(this->make(1, 2))), Interval(1));
  EXPECT_EQ(this->range(sign_enclosure(this->make(-2, -1))), Interval(-1));
  EXPECT_EQ(this->range(sign_enclosure(this->make(0, 2))), Interval(-1, 1));
  EXPECT_EQ(this->range(less_enclosure(this->make(1, 2), this->make(3, 4))), Interval(1));
  EXPECT_EQ(this->range(less_enclosure(this->make(3, 4), this->make(1, 3))), Interval(0));
  EXPECT_EQ(this->range(less_enclosure(this->make(1, 3), this->make(2, 4))), Interval(0, 1));
}

template <class T>
class RigorousContract : public NumberContract<T> {};

using RigorousTypes =
    ::testing::Types<FastInterval, BoostInterval, MpfrInterval, ChebyshevAffine, MinRangeAffine>;
TYPED_TEST_SUITE(RigorousContract, RigorousTypes);

TYPED_TEST(RigorousContract, SaysSo) { EXPECT_EQ(NumberTraits<TypeParam>::promise, Promise::rigorous); }

/// Inverse functions undo each other up to rounding, so that the result contains the operand where both are
/// defined.
TYPED_TEST(RigorousContract, InverseFunctionsEncloseTheOperand) {
  Random random(fuzz_seed(), "inverse");
  for (std::size_t i = fuzz_cases(2000); i > 0; --i) {
    const typename NumberTraits<TypeParam>::Scope one_evaluation;
    const double lower = random.uniform(0.01, 1);
    const Interval x(lower, random.uniform(lower, 1));
    const auto encloses = [&x, this](const TypeParam& result) { return subset(x, this->range(result)); };
    ASSERT_TRUE(encloses(exp(log(this->make(x))))) << to_string(x);
    ASSERT_TRUE(encloses(log(exp(this->make(x))))) << to_string(x);
    ASSERT_TRUE(encloses(sqr(sqrt(this->make(x))))) << to_string(x);
    ASSERT_TRUE(encloses(pow(cbrt(this->make(x)), 3))) << to_string(x);
    ASSERT_TRUE(encloses(sin(asin(this->make(x))))) << to_string(x);
    ASSERT_TRUE(encloses(cos(acos(this->make(x))))) << to_string(x);
    ASSERT_TRUE(encloses(tan(atan(this->make(x))))) << to_string(x);
    ASSERT_TRUE(encloses(this->make(1) / (this->make(1) / this->make(x)))) << to_string(x);
    ASSERT_TRUE(encloses((this->make(x) + this->make(0.1)) - this->make(0.1))) << to_string(x);
  }
}

/// Inclusion isotonicity: a part of the operand has its results in the results of the whole. Natural
/// extensions owe it exactly; affine forms, whose approximating lines move with the operand, do not.
template <class T>
class IsotoneContract : public NumberContract<T> {};

using IsotoneTypes = ::testing::Types<FastInterval, BoostInterval, MpfrInterval, UnroundedInterval>;
TYPED_TEST_SUITE(IsotoneContract, IsotoneTypes);

Interval random_part(Random& random, const Interval& x) {
  const double a = random_member(random, x);
  const double b = random_member(random, x);
  return {std::min(a, b), std::max(a, b)};
}

TYPED_TEST(IsotoneContract, PartsOfOperandsGivePartsOfResults) {
  const auto functions = unary_functions<TypeParam>();
  const auto operations = binary_operations<TypeParam>();
  Random random(fuzz_seed(), "isotone");
  for (std::size_t i = fuzz_cases(2000); i > 0; --i) {
    const Interval x = random_interval(random);
    const Interval y = random_interval(random);
    const Interval part_of_x = random_part(random, x);
    const Interval part_of_y = random_part(random, y);
    for (const auto& function : functions) {
      ASSERT_TRUE(subset(this->range(function.apply(this->make(part_of_x))),
                         this->range(function.apply(this->make(x)))))
          << function.name << " of " << to_string(part_of_x) << " in " << to_string(x);
    }
    for (const auto& operation : operations) {
      ASSERT_TRUE(subset(this->range(operation.apply(this->make(part_of_x), this->make(part_of_y))),
                         this->range(operation.apply(this->make(x), this->make(y)))))
          << operation.name << " of " << to_string(x) << " and " << to_string(y);
    }
  }
}

}  // namespace
}  // namespace gcslab
