// Strips contain the graph, and are as narrow as its chord and tangents where it is bent to one side.

#include "box_solver/graph_strips.h"

#include <cmath>
#include <gtest/gtest.h>

#include "base/random.h"
#include "interval/mpfr_interval.h"
#include "support/fuzz.h"

namespace gcslab {
namespace {

std::vector<Expression> steps(ExpressionGraph& graph) {
  const Expression x = graph.variable(0);
  std::vector<Expression> result;
  for (const Operation operation :
       {Operation::exp, Operation::log, Operation::sin, Operation::cos, Operation::tan, Operation::asin,
        Operation::acos, Operation::atan, Operation::abs, Operation::sqrt, Operation::cbrt, Operation::sqr})
    result.push_back(graph.apply(operation, x));
  for (const Rational& exponent : {Rational(-1), Rational(-2), Rational(3), Rational(2, 3), Rational(-3, 2)})
    result.push_back(graph.power(x, exponent));
  return result;
}

/// phi at a point in 200 bits; empty where it is undefined.
MpfrInterval value_at(Expression step, double x) {
  const Tape tape(step, 1);
  TapeEvaluator<MpfrInterval> evaluator(tape);
  const MpfrInterval point = NumberTraits<MpfrInterval>::from_interval(Interval(x));
  evaluator.evaluate({&point, 1});
  return evaluator.value();
}

StripsOfGraph strips_around(Expression step, const Interval& x) {
  const NumberTraits<FastInterval>::Scope scope;
  return GraphStrips(step).around(x);
}

TEST(GraphStrips, ContainTheGraph) {
  ExpressionGraph graph;
  Random random(fuzz_seed(), "strips");
  std::size_t bounded = 0;
  for (std::size_t i = 0; i < fuzz_cases(2000); ++i) {
    const std::vector<Expression> all = steps(graph);
    const Expression step = all[random.below(all.size())];
    const double a = random.uniform(-4, 4);
    const double width = std::ldexp(random.unit(), static_cast<int>(random.integer(-40, 3)));
    const Interval x(a, a + width);
    const auto strips = strips_around(step, x);
    const double member = random.below(4) == 0 ? (random.below(2) == 0 ? x.lower : x.upper)
                                               : std::min(x.upper, a + random.unit() * width);
    const NumberTraits<MpfrInterval>::Scope scope(200);
    const MpfrInterval value = value_at(step, member);
    if (is_empty(NumberTraits<MpfrInterval>::enclosure(value))) continue;
    for (const auto& [slope, range] : strips) {
      const MpfrInterval rest = value - NumberTraits<MpfrInterval>::from_interval(Interval(slope)) *
                                            NumberTraits<MpfrInterval>::from_interval(Interval(member));
      // The enclosure is rounded outward to doubles: within a unit of the range, which is rounded too.
      EXPECT_FALSE(disjoint(NumberTraits<MpfrInterval>::enclosure(rest), range))
          << "step " << static_cast<int>(step.operation()) << " over " << to_string(x) << " at " << member;
      if (is_bounded(range)) ++bounded;
    }
  }
  EXPECT_GT(bounded, fuzz_cases(2000));
}

TEST(GraphStrips, AreTheChordAndTheTangentsWhereTheGraphIsConvex) {
  ExpressionGraph graph;
  const auto strips = strips_around(graph.apply(Operation::exp, graph.variable(0)), {0, 1});
  const double e = std::exp(1.0);
  constexpr double kClose = 1e-14;
  EXPECT_NEAR(strips[0].slope, 1, kClose);  // t - x >= 1, the tangent at 0
  EXPECT_NEAR(strips[0].range.lower, 1, kClose);
  EXPECT_NEAR(strips[1].slope, e, kClose);  // t - e x >= 0, the tangent at 1
  EXPECT_NEAR(strips[1].range.lower, 0, kClose);
  EXPECT_NEAR(strips[2].slope, e - 1, kClose);  // t - (e - 1) x <= 1, the chord
  EXPECT_NEAR(strips[2].range.upper, 1, kClose);
}

TEST(GraphStrips, SayNothingWhereThereIsNoSlope) {
  ExpressionGraph graph;
  const auto strips = strips_around(graph.apply(Operation::log, graph.variable(0)), {0, 1});
  for (const auto& [slope, range] : strips) EXPECT_EQ(range.lower, -std::numeric_limits<double>::infinity());
}

/// The gap between strip and graph falls with the square of the width.
TEST(GraphStrips, BecomeNarrowFast) {
  ExpressionGraph graph;
  const Expression sine = graph.apply(Operation::sin, graph.variable(0));
  double before = 1e300;
  for (int halvings = 1; halvings < 10; ++halvings) {
    const double size = std::ldexp(1, -halvings);
    const Interval chord = strips_around(sine, {-0.1, -0.1 + size})[2].range;
    EXPECT_LT(width(chord), 0.6 * before);
    EXPECT_LT(width(chord), size * size);
    before = width(chord);
  }
}

}  // namespace
}  // namespace gcslab
