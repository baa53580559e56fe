#include "verifier/program.h"

#include <gtest/gtest.h>

#include "certification/system_functions.h"
#include "expression/parser.h"
#include "expression/tape_evaluator.h"
#include "interval/fast_interval.h"
#include "polynomial/recognise.h"
#include "support/fuzz.h"
#include "support/random_interval.h"
#include "verifier/box_relations.h"
#include "verifier/expansion.h"

namespace gcslab::verifier {
namespace {

const std::vector<std::string> kVariables = {"x", "y", "z"};

const char* const kTexts[] = {
    "x^2 + y^2 - 1",
    "x*y - z^3 + 2/3",
    "(x - y)*(x + y) - z/(3 + x^2)",
    "sin(x*y) + cos(z) - exp(x/4)",
    "sqrt(x^2 + 1) - log(2 + y^2) + abs(z)",
    "min(x, y) - max(y*z, x^2) + atan(x)",
    "cbrt(x) + x^(2/3) - y^(-2) + tan(z/4)",
    "asin(x/7) - acos(y/7)*z",
    "x^4*y - 3*x^2*y^3 + z^5 - pi",
    "x*x - x + y*y*y - (x - 1)^3",
    "sqrt(x) + log(y)",
};

Box random_box(Random& random) {
  Box box;
  for (int i = 0; i < 3; ++i) {
    const double lower = random.uniform(-4, 4);
    const double width = random.below(3) == 0 ? 1e-3 : random.uniform(0, 3);
    box.emplace_back(lower, lower + width);
  }
  return box;
}

RangeBox random_point(Random& random, const Box& box) {
  RangeBox point;
  for (const Interval& side : box) point.emplace_back(random_member(random, side));
  return point;
}

class ProgramOnText : public ::testing::TestWithParam<const char*> {
 protected:
  ExpressionGraph graph_;
  Expression expression_ = parse_expression(graph_, GetParam(), kVariables);
  Program program_{expression_, 3};
  Random random_{fuzz_seed(), GetParam()};
};

TEST_P(ProgramOnText, EnclosesAtLeastAsTightlyAsTheTapeOfTheSolvers) {
  const NumberTraits<FastInterval>::Scope scope;
  const Tape tape(expression_, 3);
  TapeEvaluator<FastInterval> evaluator(tape);
  for (std::size_t i = 0; i < fuzz_cases(300); ++i) {
    const Box box = random_box(random_);
    std::vector<FastInterval> fast;
    for (const Interval& side : box) fast.emplace_back(side);
    evaluator.evaluate(fast);
    EXPECT_TRUE(program_.evaluate(ranges_of(box)).is_within(evaluator.value().interval()));
    ASSERT_EQ(program_.is_defined_everywhere(), evaluator.defined_everywhere());
    if (!program_.is_defined_everywhere()) continue;
    const auto expected = evaluator.reverse_gradient();
    const auto& gradient = program_.gradient();
    for (std::size_t k = 0; k < 3; ++k) EXPECT_TRUE(gradient[k].is_within(expected[k].interval()));
  }
}

TEST_P(ProgramOnText, ValuesAndSlopesHoldBetweenPoints) {
  for (std::size_t i = 0; i < fuzz_cases(300); ++i) {
    const Box box = random_box(random_);
    const RangeBox p = random_point(random_, box);
    const RangeBox q = random_point(random_, box);
    const Range at_p = program_.evaluate(p);
    const Range at_q = program_.evaluate(q);
    const Range over_box = program_.evaluate(ranges_of(box));
    EXPECT_TRUE(at_p.is_within(over_box));
    if (!program_.is_defined_everywhere()) continue;
    const auto& gradient = program_.gradient();
    Range sum;
    for (std::size_t k = 0; k < 3; ++k) sum = sum + gradient[k] * (p[k] - q[k]);
    EXPECT_FALSE((at_p - at_q).is_disjoint_from(sum));
  }
}

TEST_P(ProgramOnText, PropagationKeepsEveryPointThatMeetsTheTarget) {
  int narrowed = 0;
  for (std::size_t i = 0; i < fuzz_cases(1000); ++i) {
    const Box box = random_box(random_);
    const RangeBox p = random_point(random_, box);
    const Interval value = program_.evaluate(p).outward();
    if (is_empty(value)) continue;
    const Range target(
        Interval(value.lower - random_.uniform(0, 0.5), value.upper + random_.uniform(0, 0.5)));
    ASSERT_TRUE(program_.propagate(ranges_of(box), target));
    for (const std::size_t k : program_.variables()) {
      EXPECT_TRUE(p[k].is_within(program_.narrowed(k)));
      if (!Range(box[k]).is_within(program_.narrowed(k))) ++narrowed;
    }
  }
  EXPECT_GT(narrowed, 0);
}

TEST_P(ProgramOnText, PolynomialTermsAreThoseOfTheRecogniser) {
  const auto terms = polynomial_terms(expression_, 3);
  const auto polynomial = recognise_polynomial(expression_, 3).polynomial;
  ASSERT_EQ(terms.has_value(), polynomial.has_value());
  if (!terms) return;
  EXPECT_EQ(terms->size(), polynomial->terms().size());
  for (const auto& [exponents, coefficient] : polynomial->terms())
    EXPECT_EQ(terms->at(exponents), coefficient);
  EXPECT_EQ(total_degree(*terms), polynomial->total_degree());
}

TEST_P(ProgramOnText, ExpansionsEqualTheFunctionAtPointsOfTheBox) {
  EquationSystem system;
  system.variables = kVariables;
  system.equations.push_back(parse_equation(*system.graph, GetParam(), kVariables));
  JudgedSystem judged(system);
  Expansion expansion(judged);
  for (std::size_t i = 0; i < fuzz_cases(200); ++i) {
    const Box box = random_box(random_);
    expansion.expand(box);
    RangeBox z;
    RangeBox x;
    for (std::size_t k = 0; k < 3; ++k) {
      // m + r z lies in the box up to the rounding of r: |z| stays away from 1.
      z.emplace_back(Range(random_.uniform(-0.999, 0.999)));
      x.push_back(Range(expansion.midpoints()[k]) + Range(expansion.radii()[k]) * z.back());
    }
    const ExpandedRow& row = expansion.row(0);
    Range sum = row.constant;
    for (std::size_t c = 0; c < row.columns.size(); ++c) {
      Range product(1.0);
      for (const auto& [variable, exponent] : expansion.columns()[row.columns[c]])
        product = product * power(z[variable], exponent);
      sum = sum + row.values[c] * product;
    }
    const Range value = judged.equations()[0].program.evaluate(x);
    if (value.is_empty()) continue;
    EXPECT_FALSE(sum.is_disjoint_from(value));
    if (!judged.equations()[0].polynomial) continue;
    EXPECT_LT(width((sum - value).outward()), 1e-60);
  }
}

TEST_P(ProgramOnText, SlopesFromACentreAreAtLeastAsTightAsTheCertifiers) {
  EquationSystem system;
  system.variables = kVariables;
  system.equations.push_back(parse_equation(*system.graph, GetParam(), kVariables));
  JudgedSystem judged(system);
  const SystemFunctions functions(system);
  const NumberTraits<FastInterval>::Scope scope;
  SystemEvaluator<FastInterval> evaluator(functions);
  Matrix<FastInterval> expected(1, 3, FastInterval());
  RangeMatrix slopes;
  for (std::size_t i = 0; i < fuzz_cases(300); ++i) {
    const Box box = random_box(random_);
    const Box centre = i % 2 == 0 ? random_box(random_) : Box{midpoint(box[0]), midpoint(box[1]), box[2]};
    std::vector<FastInterval> fast_box;
    std::vector<FastInterval> fast_centre;
    for (const Interval& side : box) fast_box.emplace_back(side);
    for (const Interval& side : centre) fast_centre.emplace_back(side);
    const bool is_defined = judged.slopes(ranges_of(box), ranges_of(centre), slopes);
    ASSERT_EQ(is_defined, evaluator.slopes(fast_box, fast_centre, expected));
    if (!is_defined) continue;
    for (std::size_t k = 0; k < 3; ++k) EXPECT_TRUE(slopes[0][k].is_within(expected(0, k).interval()));
    const RangeBox p = random_point(random_, box);
    const RangeBox c = random_point(random_, centre);
    Program& program = judged.equations()[0].program;
    const Range at_p = program.evaluate(p);
    const Range at_c = program.evaluate(c);
    Range sum;
    for (std::size_t k = 0; k < 3; ++k) sum = sum + slopes[0][k] * (p[k] - c[k]);
    EXPECT_FALSE((at_p - at_c).is_disjoint_from(sum));
  }
}

INSTANTIATE_TEST_SUITE_P(Texts, ProgramOnText, ::testing::ValuesIn(kTexts));

TEST(Program, AConstantIsLeftAsItIsByPropagation) {
  ExpressionGraph graph;
  Program one(graph.constant(1), 1);
  const RangeBox box = {Range(Interval(0, 1))};
  EXPECT_FALSE(one.propagate(box, 0.0));
  EXPECT_EQ(one.evaluate(box).outward(), Interval(1));
}

TEST(Program, TheRoundingErrorBoundCoversDoubles) {
  Random random(fuzz_seed(), "verifier.rounding");
  ExpressionGraph graph;
  const Expression e = parse_expression(graph, "(x - 1)^7 - y*z + exp(x) - sqrt(y^2 + 1)", kVariables);
  Program program(e, 3);
  for (std::size_t i = 0; i < fuzz_cases(1000); ++i) {
    const double x = random.uniform(-3, 3);
    const double y = random.uniform(-3, 3);
    const double z = random.uniform(-3, 3);
    const RangeBox point = {x, y, z};
    const Range value = program.evaluate(point);
    program.gradient();
    const double rounded = std::pow(x - 1, 7) - y * z + std::exp(x) - std::sqrt(y * y + 1);
    const Interval error = abs(value - Range(rounded)).outward();
    EXPECT_LE(error.upper, program.double_rounding_error());
    EXPECT_LT(program.double_rounding_error(), 1e-8);
  }
}

}  // namespace
}  // namespace gcslab::verifier
