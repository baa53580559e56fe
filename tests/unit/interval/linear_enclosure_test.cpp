#include "interval/linear_enclosure.h"

#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include "base/random.h"

namespace gcslab {
namespace {

struct Study {
  const char* name;
  const UnivariateFunction* function;
  Interval box;
};

const std::vector<Study>& studies() {
  static const IntegerPower square(2), cube(3), fourth(4), inverse(-1), inverse_square(-2);
  static const RationalPower two_thirds(Rational(2, 3)), inverse_root(Rational(-1, 2));
  static const std::vector<Study> all = {{"sqrt", &sqrt_function(), {0, 3}},
                                         {"cbrt left", &cbrt_function(), {-4, 0}},
                                         {"exp", &exp_function(), {-1, 2}},
                                         {"log", &log_function(), {0.1, 5}},
                                         {"sin concave", &sin_function(), {0, 3.1}},
                                         {"sin convex", &sin_function(), {-3, 0}},
                                         {"sin far", &sin_function(), {101, 103}},
                                         {"cos concave", &cos_function(), {-1.5, 1.2}},
                                         {"cos convex", &cos_function(), {2, 4}},
                                         {"tan", &tan_function(), {0, 1.5}},
                                         {"tan left", &tan_function(), {-1.5, 0}},
                                         {"tan far", &tan_function(), {9.5, 10.9}},
                                         {"asin", &asin_function(), {0, 1}},
                                         {"asin left", &asin_function(), {-1, -0.5}},
                                         {"acos", &acos_function(), {0.25, 1}},
                                         {"atan", &atan_function(), {0, 6}},
                                         {"atan left", &atan_function(), {-6, -1}},
                                         {"square", &square, {-1, 3}},
                                         {"cube", &cube, {0, 3}},
                                         {"cube left", &cube, {-2, 0}},
                                         {"fourth", &fourth, {-2, 1}},
                                         {"inverse", &inverse, {0.5, 4}},
                                         {"inverse left", &inverse, {-4, -0.5}},
                                         {"inverse square", &inverse_square, {-4, -0.5}},
                                         {"two thirds", &two_thirds, {-1, 0}},
                                         {"inverse root", &inverse_root, {0.25, 9}}};
  return all;
}

TEST(ChebyshevLines, AreFoundWhereTheFunctionIsConvexOrConcave) {
  const UpwardRounding upward;
  for (const Study& study : studies()) {
    EXPECT_NE(study.function->curvature(study.box), Curvature::mixed) << study.name;
    EXPECT_TRUE(enclose_linearly(*study.function, study.box, Approximation::chebyshev)) << study.name;
  }
}

/// The band touches the function: at both ends and, on the other side, at the tangent point.
TEST(ChebyshevLines, AreTheNearestOnes) {
  const UpwardRounding upward;
  for (const Study& study : studies()) {
    const auto lines = enclose_linearly(*study.function, study.box, Approximation::chebyshev);
    Interval seen;
    for (int i = 0; i <= 2000; ++i) {
      const double x = study.box.lower + (study.box.upper - study.box.lower) * i / 2000;
      const double at = std::min(x, study.box.upper);
      const FastInterval residual =
          study.function->value(FastInterval(at)) - FastInterval(lines->slope) * FastInterval(at);
      seen = hull(seen, residual.interval());
      EXPECT_TRUE(subset(residual.interval(), {lines->offset.lower - 1e-12, lines->offset.upper + 1e-12}))
          << study.name << " at " << at;
    }
    EXPECT_LT(width(lines->offset), 1.001 * width(seen) + 1e-12) << study.name;
  }
}

TEST(MinRangeLines, HaveTheLeastRangeForMonotoneFunctions) {
  const UpwardRounding upward;
  for (const Study& study : studies()) {
    const auto lines = enclose_linearly(*study.function, study.box, Approximation::min_range);
    if (!lines) continue;  // not monotone, or steep everywhere
    const Interval range = study.function->value(FastInterval(study.box)).interval();
    const FastInterval band =
        FastInterval(lines->slope) * FastInterval(study.box) + FastInterval(lines->offset);
    EXPECT_LT(width(band.interval()), width(range) * (1 + 1e-12)) << study.name;
  }
}

TEST(LinearEnclosures, ContainTheFunctionOnRandomIntervals) {
  const UpwardRounding upward;
  Random random(1, "linear_enclosure");
  for (int i = 0; i < 20000; ++i) {
    const Study& study = studies()[random.below(studies().size())];
    const double a = random.uniform(study.box.lower, study.box.upper);
    const double b = random.uniform(study.box.lower, study.box.upper);
    const Interval x(std::min(a, b), std::max(a, b));
    const auto approximation = random.below(2) == 0 ? Approximation::chebyshev : Approximation::min_range;
    const auto lines = enclose_linearly(*study.function, x, approximation);
    if (!lines) continue;
    const double at = random.uniform(x.lower, x.upper);
    const FastInterval line = FastInterval(lines->slope) * FastInterval(at) + FastInterval(lines->offset);
    EXPECT_FALSE(disjoint(study.function->value(FastInterval(at)).interval(), line.interval()))
        << study.name << " on " << to_string(x) << " at " << at;
  }
}

TEST(LinearEnclosures, OfTheAbsoluteValue) {
  const UpwardRounding upward;
  const auto lines = enclose_absolute_value({-1, 3}, Approximation::chebyshev);
  ASSERT_TRUE(lines);
  EXPECT_EQ(lines->slope, 0.5);
  EXPECT_EQ(lines->offset, Interval(0, 1.5));
  EXPECT_FALSE(enclose_absolute_value({-1, 3}, Approximation::min_range));
  EXPECT_EQ(enclose_absolute_value({1, 3}, Approximation::min_range)->slope, 1);
  EXPECT_EQ(enclose_absolute_value({-3, -1}, Approximation::chebyshev)->slope, -1);
}

TEST(LinearEnclosures, AreNotMadeWhereTheDerivativeIsUnbounded) {
  const UpwardRounding upward;
  EXPECT_FALSE(enclose_linearly(log_function(), {0, 1}, Approximation::chebyshev));
  EXPECT_FALSE(enclose_linearly(cbrt_function(), {0, 0}, Approximation::min_range));
  EXPECT_EQ(sin_function().curvature({-1, 1}), Curvature::mixed);
  EXPECT_TRUE(enclose_linearly(sin_function(), {-1, 1}, Approximation::chebyshev));  // by the least range
}

}  // namespace
}  // namespace gcslab
