#include "interval/quadrant.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace gcslab::elementary {
namespace {

constexpr double kHalfPi = std::numbers::pi / 2;  // below pi/2

TEST(Quadrants, OfSmallArguments) {
  EXPECT_EQ(quadrant_span(0.0, 0.0).first, 0);
  EXPECT_EQ(quadrant_span(1.0, 1.0).first, 0);
  EXPECT_EQ(quadrant_span(2.0, 2.0).first, 1);
  EXPECT_EQ(quadrant_span(4.0, 4.0).first, 2);
  EXPECT_EQ(quadrant_span(5.0, 5.0).first, 3);
  EXPECT_EQ(quadrant_span(-1.0, -1.0).first, 3);
  EXPECT_EQ(quadrant_span(-1e-300, -1e-300).first, 3);
}

TEST(Quadrants, BesideMultiplesOfHalfPi) {
  for (int k = 1; k <= 60; ++k) {
    const double near = k * kHalfPi;
    const double below = near * (1 - 0x1p-50);
    const double above = near * (1 + 0x1p-50);
    EXPECT_EQ(quadrant_span(below, below).first, (k - 1) % 4) << k;
    EXPECT_EQ(quadrant_span(above, above).first, k % 4) << k;
    EXPECT_EQ(quadrant_span(below, above).crossings, 1) << k;
  }
}

TEST(Quadrants, CrossingsAreCountedUpToAPeriod) {
  EXPECT_EQ(quadrant_span(0.0, 1.0).crossings, 0);
  EXPECT_EQ(quadrant_span(-1.0, 0.0).crossings, 1);
  EXPECT_EQ(quadrant_span(0.0, 2.0).crossings, 1);
  EXPECT_EQ(quadrant_span(0.0, 100.0).crossings, 4);
  const QuadrantSpan span = quadrant_span(1.0, 4.0);  // quadrants 0, 1, 2
  EXPECT_FALSE(span.crosses(0));
  EXPECT_TRUE(span.crosses(1));
  EXPECT_TRUE(span.crosses(2));
  EXPECT_FALSE(span.crosses(3));
}

TEST(Quadrants, OfMpfrNumbersAreThoseOfEqualDoubles) {
  mpfr_t lower, upper;
  mpfr_inits2(200, lower, upper, static_cast<mpfr_ptr>(nullptr));
  for (const double x : {-1e300, -1e22, -7.0, -1e-9, 0.0, 1.0, 3.0, 1e15, 6e100}) {
    for (const double width : {0.0, 1.0, 3.0, 40.0}) {
      mpfr_set_d(lower, x, MPFR_RNDN);
      mpfr_set_d(upper, x + width, MPFR_RNDN);
      const QuadrantSpan expected = quadrant_span(x, x + width);
      const QuadrantSpan span = quadrant_span(lower, upper);
      EXPECT_EQ(span.first, expected.first) << x << " " << width;
      EXPECT_EQ(span.crossings, expected.crossings) << x << " " << width;
    }
  }
  mpfr_set_ui_2exp(lower, 1, 1000000, MPFR_RNDN);
  EXPECT_EQ(quadrant_span(lower, lower).crossings, 4);  // too large to decide: safe
  mpfr_clears(lower, upper, static_cast<mpfr_ptr>(nullptr));
}

}  // namespace
}  // namespace gcslab::elementary
