#include "interval/accurate_functions.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <mpfr.h>
#include <string>

#include "base/random.h"
#include "interval/rounding.h"
#include "support/fuzz.h"

namespace gcslab::elementary {
namespace {

struct Tested {
  const char* name;
  AccurateFunction function;
  int (*exact)(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t);
  int lowest_exponent;
  int highest_exponent;
  bool positive;
};

constexpr Tested kTested[] = {
    {"exp", accurate_exp, mpfr_exp, -40, 10, false}, {"log", accurate_log, mpfr_log, -1000, 999, true},
    {"sin", accurate_sin, mpfr_sin, -40, 15, false}, {"cos", accurate_cos, mpfr_cos, -40, 15, false},
    {"tan", accurate_tan, mpfr_tan, -40, 15, false}, {"atan", accurate_atan, mpfr_atan, -40, 100, false}};

/// The error in units of the claimed bound, by MPFR at 250 bits.
double error_over_bound(const Tested& tested, double x) {
  const AccurateValue value = tested.function(opaque(x));
  if (!value.known) return 0;
  mpfr_t exact, part;
  mpfr_inits2(250, exact, part, static_cast<mpfr_ptr>(nullptr));
  mpfr_set_d(part, x, MPFR_RNDN);
  tested.exact(exact, part, MPFR_RNDN);
  mpfr_sub_d(exact, exact, value.high, MPFR_RNDN);
  mpfr_sub_d(exact, exact, value.low, MPFR_RNDN);
  mpfr_div_d(exact, exact, value.error, MPFR_RNDN);
  const double ratio = std::fabs(mpfr_get_d(exact, MPFR_RNDN));
  mpfr_clears(exact, part, static_cast<mpfr_ptr>(nullptr));
  return ratio;
}

/// Arguments of all sizes, beside table entries, beside 1 and beside multiples of pi/128.
double random_argument(const Tested& tested, Random& random) {
  const double sign = tested.positive || random.below(2) == 0 ? 1 : -1;
  const double nudge = 1 + static_cast<double>(random.integer(-3, 3)) * 0x1p-52;
  switch (random.below(6)) {
    case 0:
      return sign * static_cast<double>(random.integer(1, 1000)) / 128 * nudge;
    case 1:
      return sign * static_cast<double>(random.integer(1, 100000)) * 0x1.921fb54442d18p-7 * nudge;
    case 2:
      return sign * (1 + random.uniform(-1, 1) * std::ldexp(1.0, -static_cast<int>(random.integer(3, 50))));
    case 3:
      return sign * static_cast<double>(random.integer(1, 40000)) * 0x1.62e42fefa39efp-7 * nudge;
    case 4:
      return sign * random.uniform(0.001, 10);
    default:
      return sign * std::ldexp(random.uniform(1, 2), static_cast<int>(random.integer(
                                                         tested.lowest_exponent, tested.highest_exponent)));
  }
}

/// The proofs leave a factor of two or more.
TEST(AccurateFunctions, ErrorsStayBelowHalfTheBoundInBothModes) {
  const std::uint64_t seed = fuzz_seed();
  for (const Tested& tested : kTested) {
    Random random(seed, tested.name);
    double largest = 0;
    for (std::size_t i = fuzz_cases(20000); i > 0; --i) {
      const double x = random_argument(tested, random);
      double ratio = error_over_bound(tested, x);
      {
        const UpwardRounding upward;
        ratio = std::max(ratio, error_over_bound(tested, x));
      }
      ASSERT_LT(ratio, 0.5) << tested.name << " at " << std::hexfloat << x;
      largest = std::max(largest, ratio);
    }
    RecordProperty(tested.name, std::to_string(largest));
    EXPECT_GT(largest, 0);
  }
}

template <RoundingMode mode>
double error_over_bound_rounding(const Tested& tested, double x) {
  const RoundingScope<mode> scope;
  return error_over_bound(tested, x);
}

double largest_error_over_bound(const Tested& tested, double x) {
  return std::max({error_over_bound_rounding<RoundingMode::nearest>(tested, x),
                   error_over_bound_rounding<RoundingMode::downward>(tested, x),
                   error_over_bound_rounding<RoundingMode::upward>(tested, x),
                   error_over_bound_rounding<RoundingMode::to_zero>(tested, x)});
}

/// The doubles beside the middles between table entries, where the argument rounds to either: before 1/128,
/// a power of two, the difference from an entry may have more than 53 bits.
TEST(AccurateFunctions, ErrorsStayBelowHalfTheBoundBesideTheMiddlesBetweenTableEntries) {
  for (const Tested& tested : kTested) {
    for (int i = 1; i <= 256; ++i) {
      for (const double middle : {i / 128.0, 128.0 / i, i * 0x1.921fb54442d18p-7, i * 0x1.62e42fefa39efp-8}) {
        const double before = std::nextafter(middle, 0.0);
        const double after = std::nextafter(middle, 1000.0);
        for (const double x : {before, middle, after}) {
          ASSERT_LT(largest_error_over_bound(tested, x), 0.5) << tested.name << " at " << std::hexfloat << x;
        }
      }
    }
  }
}

TEST(AccurateFunctions, ClaimNothingOutsideTheirRange) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (const double x : {0.0, 1e-310, kInfinity, -kInfinity, std::numeric_limits<double>::quiet_NaN()}) {
    for (const Tested& tested : kTested) EXPECT_FALSE(tested.function(x).known) << tested.name << " at " << x;
  }
  EXPECT_FALSE(accurate_exp(700).known);
  EXPECT_FALSE(accurate_log(-1).known);
  EXPECT_FALSE(accurate_log(1).known);
  EXPECT_FALSE(accurate_sin(1e6).known);
}

}  // namespace
}  // namespace gcslab::elementary
