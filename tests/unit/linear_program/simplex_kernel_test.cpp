// The vector loops against the sentences that define them, on random numbers with many ties and zeros.

#include "linear_program/simplex_kernel.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <vector>

#include "base/random.h"
#include "support/fuzz.h"

namespace gcslab {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Constraints {
  std::vector<double> value, rate, lower, upper;
};

Constraints random_constraints(Random& random) {
  Constraints result;
  const std::size_t stride = 4 * (1 + random.below(5));
  for (std::size_t k = 0; k < stride; ++k) {
    const double value = static_cast<double>(random.integer(-3, 3));
    result.value.push_back(value);
    result.rate.push_back(static_cast<double>(random.integer(-2, 2)) * 0.5);
    result.lower.push_back(random.below(3) == 0 ? -kInfinity
                                                : value - static_cast<double>(random.integer(-1, 3)));
    result.upper.push_back(random.below(3) == 0 ? kInfinity
                                                : value + static_cast<double>(random.integer(-1, 3)));
  }
  return result;
}

double room(const Constraints& c, std::size_t k) {
  return std::max(c.rate[k] > 0 ? c.upper[k] - c.value[k] : c.value[k] - c.lower[k], 0.0);
}

TEST(SimplexKernel, RatioTestTakesTheLargestRateWithinTheTolerance) {
  Random random(fuzz_seed(), "ratio test");
  constexpr double kTolerance = 0.25;
  for (std::size_t i = 0; i < fuzz_cases(20000); ++i) {
    const Constraints c = random_constraints(random);
    double loosest = kInfinity;
    for (std::size_t k = 0; k < c.rate.size(); ++k) {
      if (c.rate[k] != 0) loosest = std::min(loosest, (room(c, k) + kTolerance) / std::abs(c.rate[k]));
    }
    double largest = 0;
    for (std::size_t k = 0; k < c.rate.size(); ++k) {
      if (room(c, k) <= loosest * std::abs(c.rate[k]) && loosest < kInfinity) {
        largest = std::max(largest, std::abs(c.rate[k]));
      }
    }
    const auto found = simplex_kernel::ratio_test(c.value.data(), c.rate.data(), c.lower.data(),
                                                  c.upper.data(), c.rate.size(), kTolerance, 1e-9);
    if (loosest == kInfinity) {
      ASSERT_EQ(found.step, kInfinity);
      continue;
    }
    ASSERT_EQ(std::abs(c.rate[found.constraint]), largest);
    ASSERT_EQ(found.step, room(c, found.constraint) / largest);
    ASSERT_LE(found.step, loosest);
  }
}

TEST(SimplexKernel, LargestViolationIsTheLargest) {
  Random random(fuzz_seed(), "violation");
  for (std::size_t i = 0; i < fuzz_cases(20000); ++i) {
    const Constraints c = random_constraints(random);
    double largest = -kInfinity;
    for (std::size_t k = 0; k < c.value.size(); ++k) {
      largest = std::max({largest, c.lower[k] - c.value[k], c.value[k] - c.upper[k]});
    }
    const auto found =
        simplex_kernel::largest_violation(c.value.data(), c.lower.data(), c.upper.data(), c.value.size());
    ASSERT_EQ(found.amount, largest);
    if (largest == -kInfinity) continue;
    const std::size_t k = found.constraint;
    ASSERT_EQ(std::max(c.lower[k] - c.value[k], c.value[k] - c.upper[k]), largest);
  }
}

TEST(SimplexKernel, SteepestHasTheBestScoreOfThoseThatFall) {
  Random random(fuzz_seed(), "steepest");
  for (std::size_t i = 0; i < fuzz_cases(20000); ++i) {
    const Constraints c = random_constraints(random);
    std::vector<double> inward, squared_length;
    for (std::size_t k = 0; k < c.value.size(); ++k) {
      inward.push_back(static_cast<double>(random.integer(-1, 1)));
      squared_length.push_back(std::ldexp(1.0, static_cast<int>(random.integer(-2, 2))));
    }
    const std::size_t count = c.value.size();
    const auto score = [&](std::size_t k) {
      const double fall = -inward[k] * c.value[k];
      return fall > 0.5 ? fall * fall / squared_length[k] : 0;
    };
    const std::size_t found =
        simplex_kernel::steepest(inward.data(), c.value.data(), squared_length.data(), count, 0.5);
    double best = 0;
    for (std::size_t k = 0; k < count; ++k) best = std::max(best, score(k));
    ASSERT_EQ(found == count, best == 0);
    ASSERT_EQ(found < count ? score(found) : 0, best);
  }
}

}  // namespace
}  // namespace gcslab
