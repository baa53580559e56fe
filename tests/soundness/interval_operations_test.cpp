// Every operation of every rigorous interval type encloses the true value at members of random operands. The
// true values are exact rationals for + - * / powers and roots, and MPFR's, rounded down and up at 300 bits,
// for the other functions: an end of at most 53 bits is on the right side of the exact value if and only if
// it is of its 300-bit bound.

#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <mpfr.h>
#include <optional>
#include <string>
#include <vector>

#include "interval/affine_form.h"
#include "interval/boost_interval.h"
#include "interval/elementary.h"
#include "interval/fast_interval.h"
#include "interval/mpfr_interval.h"
#include "interval/unrounded_interval.h"
#include "support/fuzz.h"
#include "support/random_interval.h"

namespace gcslab {
namespace {

enum class Operation {
  add,
  subtract,
  multiply,
  divide,
  min,
  max,
  negate,
  abs,
  sqr,
  pow,
  rational_pow,
  sqrt,
  cbrt,
  exp,
  log,
  sin,
  cos,
  tan,
  asin,
  acos,
  atan
};

struct Case {
  Operation operation;
  const char* name;
  int operands = 1;
};

constexpr std::array kCases = {Case{Operation::add, "add", 2},
                               Case{Operation::subtract, "subtract", 2},
                               Case{Operation::multiply, "multiply", 2},
                               Case{Operation::divide, "divide", 2},
                               Case{Operation::min, "min", 2},
                               Case{Operation::max, "max", 2},
                               Case{Operation::negate, "negate"},
                               Case{Operation::abs, "abs"},
                               Case{Operation::sqr, "sqr"},
                               Case{Operation::pow, "pow"},
                               Case{Operation::rational_pow, "rational_pow"},
                               Case{Operation::sqrt, "sqrt"},
                               Case{Operation::cbrt, "cbrt"},
                               Case{Operation::exp, "exp"},
                               Case{Operation::log, "log"},
                               Case{Operation::sin, "sin"},
                               Case{Operation::cos, "cos"},
                               Case{Operation::tan, "tan"},
                               Case{Operation::asin, "asin"},
                               Case{Operation::acos, "acos"},
                               Case{Operation::atan, "atan"}};

template <class T>
T apply(Operation operation, const T& x, const T& y, const Rational& exponent) {
  switch (operation) {
    case Operation::add:
      return x + y;
    case Operation::subtract:
      return x - y;
    case Operation::multiply:
      return x * y;
    case Operation::divide:
      return x / y;
    case Operation::min:
      return min(x, y);
    case Operation::max:
      return max(x, y);
    case Operation::negate:
      return -x;
    case Operation::abs:
      return abs(x);
    case Operation::sqr:
      return sqr(x);
    case Operation::pow:
      return pow(x, static_cast<int>(exponent.get_num().get_si()));
    case Operation::rational_pow:
      return pow(x, exponent);
    case Operation::sqrt:
      return sqrt(x);
    case Operation::cbrt:
      return cbrt(x);
    case Operation::exp:
      return exp(x);
    case Operation::log:
      return log(x);
    case Operation::sin:
      return sin(x);
    case Operation::cos:
      return cos(x);
    case Operation::tan:
      return tan(x);
    case Operation::asin:
      return asin(x);
    case Operation::acos:
      return acos(x);
    case Operation::atan:
      break;
  }
  return atan(x);
}

/// An exact extended number: a finite rational, or an infinite end of an interval.
bool at_most(double end, const Rational& value) { return std::isinf(end) ? end < 0 : Rational(end) <= value; }
bool at_least(double end, const Rational& value) {
  return std::isinf(end) ? end > 0 : Rational(end) >= value;
}

bool contains_exact(const Interval& result, const Rational& value) {
  return !is_empty(result) && at_most(result.lower, value) && at_least(result.upper, value);
}

Rational power(const Rational& x, unsigned long n) {
  Rational result;
  mpz_pow_ui(result.get_num_mpz_t(), x.get_num_mpz_t(), n);
  mpz_pow_ui(result.get_den_mpz_t(), x.get_den_mpz_t(), n);
  return result;
}

/// Sign of y - x^(p/q), for odd q or x >= 0, with q > 0: that of y^q - x^p where raising to the q-th power
/// keeps order.
int compare_with_root(const Rational& y, const Rational& x_to_p, unsigned long q) {
  if (q % 2 == 0 && y < 0) return -1;
  return cmp(power(y, q), x_to_p);
}

/// Whether x^exponent, exact, lies in the result; true where it is not defined.
bool encloses_power(const Interval& result, const Rational& x, const Rational& exponent) {
  const long p = exponent.get_num().get_si();
  const unsigned long q = exponent.get_den().get_ui();
  if ((q % 2 == 0 && x < 0) || (p < 0 && x == 0)) return true;
  Rational x_to_p = power(x, static_cast<unsigned long>(std::labs(p)));
  if (p < 0) x_to_p = 1 / x_to_p;
  if (is_empty(result)) return false;
  return (std::isinf(result.lower) || compare_with_root(Rational(result.lower), x_to_p, q) <= 0) &&
         (std::isinf(result.upper) || compare_with_root(Rational(result.upper), x_to_p, q) >= 0);
}

using MpfrFunction = int (*)(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t);

/// Whether f(x) lies in the result; true where it is not defined.
bool encloses_function(const Interval& result, MpfrFunction f, double x) {
  mpfr_t argument, value;
  mpfr_init2(argument, 53);
  mpfr_init2(value, 300);
  mpfr_set_d(argument, x, MPFR_RNDN);
  f(value, argument, MPFR_RNDD);
  bool holds = mpfr_number_p(value) == 0;  // a pole or outside the domain
  if (!holds && !is_empty(result)) {
    const bool below = mpfr_cmp_d(value, result.lower) >= 0;
    f(value, argument, MPFR_RNDU);
    holds = below && mpfr_cmp_d(value, result.upper) <= 0;
  }
  mpfr_clear(argument);
  mpfr_clear(value);
  return holds;
}

bool encloses(Operation operation, const Interval& result, double x, double y, const Rational& exponent) {
  const Rational a(x);
  const Rational b(y);
  switch (operation) {
    case Operation::add:
      return contains_exact(result, a + b);
    case Operation::subtract:
      return contains_exact(result, a - b);
    case Operation::multiply:
      return contains_exact(result, a * b);
    case Operation::divide:
      return b == 0 || contains_exact(result, a / b);
    case Operation::min:
      return contains_exact(result, a < b ? a : b);
    case Operation::max:
      return contains_exact(result, a < b ? b : a);
    case Operation::negate:
      return contains_exact(result, -a);
    case Operation::abs:
      return contains_exact(result, ::abs(a));
    case Operation::sqr:
      return contains_exact(result, a * a);
    case Operation::pow:
    case Operation::rational_pow:
      return encloses_power(result, a, exponent);
    case Operation::sqrt:
      return encloses_power(result, a, Rational(1, 2));
    case Operation::cbrt:
      return encloses_power(result, a, Rational(1, 3));
    case Operation::exp:
      return encloses_function(result, mpfr_exp, x);
    case Operation::log:
      return encloses_function(result, mpfr_log, x);
    case Operation::sin:
      return encloses_function(result, mpfr_sin, x);
    case Operation::cos:
      return encloses_function(result, mpfr_cos, x);
    case Operation::tan:
      return encloses_function(result, mpfr_tan, x);
    case Operation::asin:
      return encloses_function(result, mpfr_asin, x);
    case Operation::acos:
      return encloses_function(result, mpfr_acos, x);
    case Operation::atan:
      break;
  }
  return encloses_function(result, mpfr_atan, x);
}

Rational random_exponent(Operation operation, Random& random) {
  if (operation == Operation::pow) return Rational(random.integer(-5, 7));
  constexpr std::array<std::pair<int, int>, 9> kExponents = {
      {{1, 2}, {3, 2}, {-1, 2}, {1, 3}, {2, 3}, {-2, 3}, {-1, 5}, {3, 5}, {2, 1}}};
  const auto [p, q] = kExponents[random.below(kExponents.size())];
  return Rational(p, q);
}

class IntervalOperations : public ::testing::TestWithParam<Case> {};

/// The enclosure that T computes for one operation on two boxes.
template <class T>
Interval computed(Operation operation, const Interval& x, const Interval& y, const Rational& exponent) {
  using Traits = NumberTraits<T>;
  const typename Traits::Scope scope;
  return Traits::enclosure(apply(operation, Traits::from_interval(x), Traits::from_interval(y), exponent));
}

/// What each rigorous type computes for the same operation on the same boxes.
struct Computed {
  const char* type;
  Interval result;
};

std::vector<Computed> computed_by_all(Operation operation, const Interval& x, const Interval& y,
                                      const Rational& exponent) {
  return {{"FastInterval", computed<FastInterval>(operation, x, y, exponent)},
          {"BoostInterval", computed<BoostInterval>(operation, x, y, exponent)},
          {"MpfrInterval", computed<MpfrInterval>(operation, x, y, exponent)},
          {"ChebyshevAffine", computed<ChebyshevAffine>(operation, x, y, exponent)},
          {"MinRangeAffine", computed<MinRangeAffine>(operation, x, y, exponent)}};
}

// The true value is compared with the intersection of all results, so that it is computed once: it lies in
// each of them when it lies in that.
TEST_P(IntervalOperations, EncloseTheTrueValueAtMembersOfRandomOperands) {
  const Case& tested = GetParam();
  Random random(fuzz_seed(), tested.name);
  for (std::size_t i = fuzz_cases(10000); i > 0; --i) {
    const Interval x = random_interval(random);
    const Interval y = random_interval(random);
    const Rational exponent = random_exponent(tested.operation, random);
    const double a = random_member(random, x);
    const double b = random_member(random, y);
    const std::vector<Computed> all = computed_by_all(tested.operation, x, y, exponent);
    Interval common = Interval::entire();
    for (const Computed& one : all) common = intersection(common, one.result);
    if (encloses(tested.operation, common, a, b, exponent)) continue;
    for (const auto& [type, result] : all) {
      ASSERT_TRUE(encloses(tested.operation, result, a, b, exponent))
          << type << ": " << tested.name << " of " << to_string(x) << " and " << to_string(y) << ", exponent "
          << exponent << ", at " << a << " and " << b << " is not in " << to_string(result)
          << "; members: " << std::hexfloat << a << " " << b << ", result " << result.lower << " "
          << result.upper;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Operations, IntervalOperations, ::testing::ValuesIn(kCases),
                         [](const auto& entry) { return std::string(entry.param.name); });

/// An MPFR interval has no limits of exponent, so that its ends, rounded once more to double, are the
/// tightest.
template <class T>
void expect_tightest(Operation operation, std::uint64_t seed) {
  Random random(seed, "tightness");
  for (std::size_t i = fuzz_cases(10000); i > 0; --i) {
    const Interval x = random_interval(random);
    const Interval y = random_interval(random);
    ASSERT_EQ(computed<T>(operation, x, y, 0), computed<MpfrInterval>(operation, x, y, 0))
        << static_cast<int>(operation) << " of " << to_string(x) << " and " << to_string(y);
  }
}

TEST(IntervalTightness, FastArithmeticGivesTheTightestDoubles) {
  const std::uint64_t seed = fuzz_seed();
  for (const Operation operation :
       {Operation::add, Operation::subtract, Operation::multiply, Operation::divide, Operation::sqr,
        Operation::sqrt, Operation::abs, Operation::min, Operation::max}) {
    expect_tightest<FastInterval>(operation, seed);
  }
}

TEST(IntervalTightness, BoostArithmeticGivesTheTightestDoubles) {
  const std::uint64_t seed = fuzz_seed();
  for (const Operation operation :
       {Operation::add, Operation::subtract, Operation::multiply, Operation::divide, Operation::sqr,
        Operation::sqrt, Operation::abs, Operation::min, Operation::max}) {
    expect_tightest<BoostInterval>(operation, seed);
  }
}

TEST(IntervalTightness, ElementaryFunctionsGiveTheTightestDoubles) {
  const std::uint64_t seed = fuzz_seed();
  for (const Operation operation :
       {Operation::exp, Operation::log, Operation::sin, Operation::cos, Operation::tan, Operation::asin,
        Operation::acos, Operation::atan, Operation::cbrt}) {
    expect_tightest<FastInterval>(operation, seed);
  }
}

/// The baseline must be seen to fail, or the suite would not notice a type that does not round outward.
TEST(UnroundedBaseline, MissesOneThird) {
  const Interval third = computed<UnroundedInterval>(Operation::divide, 1, 3, 0);
  EXPECT_FALSE(contains_exact(third, Rational(1, 3)));
  EXPECT_TRUE(contains_exact(computed<FastInterval>(Operation::divide, 1, 3, 0), Rational(1, 3)));
}

TEST(UnroundedBaseline, MissesTheTrueValueOfRandomOperations) {
  Random random(fuzz_seed(), "unrounded");
  for (const Operation operation :
       {Operation::add, Operation::multiply, Operation::divide, Operation::exp, Operation::sin}) {
    int misses = 0;
    for (int i = 0; i < 100; ++i) {
      const double x = random.uniform(0.5, 3);
      const double y = random.uniform(0.5, 3);
      const Interval result = computed<UnroundedInterval>(operation, x, y, 0);
      misses += encloses(operation, result, x, y, 0) ? 0 : 1;
    }
    EXPECT_GT(misses, 0) << static_cast<int>(operation);
  }
}

}  // namespace
}  // namespace gcslab
