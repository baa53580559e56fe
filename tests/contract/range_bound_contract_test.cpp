// One suite for every registered range bound: a new bound is tested without an edit here. Exact values of
// random polynomials are compared with all bounds at once in tests/soundness/range_bound_test.cpp.

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/random.h"
#include "enclosure/bound_registry.h"
#include "expression/parser.h"
#include "expression/tape_evaluator.h"
#include "interval/arithmetic.h"
#include "support/fuzz.h"
#include "support/range_bound_cases.h"

namespace gcslab {
namespace {

using namespace bound_cases;

std::string name_of_choice(const testing::TestParamInfo<BoundChoice>& info) { return info.param.name(); }

std::vector<std::string> names(int variables) {
  const std::vector<std::string> all = {"x", "y", "z"};
  return {all.begin(), all.begin() + variables};
}

class RangeBoundContract : public testing::TestWithParam<BoundChoice> {
 protected:
  std::unique_ptr<RangeBound> make(const BoundTarget& target) const { return GetParam().make(target); }
  bool takes_transcendental() const {
    auto graph = std::make_shared<ExpressionGraph>();
    const BoundTarget target(graph, graph->apply(Operation::exp, graph->variable(0)), 1);
    try {
      static_cast<void>(make(target));
      return true;
    } catch (const NotApplicable&) {
      return false;
    }
  }
};

TEST_P(RangeBoundContract, LeavingReturnsToTheSameBox) {
  auto graph = std::make_shared<ExpressionGraph>();
  const Expression f = parse_expression(*graph, "x^3 + y^3 - 3*x*y", names(2));
  const auto bound = make(BoundTarget(graph, f, 2));
  const Box whole = {{-2, 2}, {-2, 2}}, left = {{-2, 0}, {-2, 2}}, corner = {{-2, 0}, {0, 2}};
  const auto walk = bound->walk(whole, 4);
  const Interval at_whole = walk->bound(whole);
  walk->enter(0, Half::lower);
  const Interval at_left = walk->bound(left);
  walk->enter(1, Half::upper);
  static_cast<void>(walk->bound(corner));
  walk->leave();
  EXPECT_EQ(walk->bound(left), at_left);
  walk->leave();
  walk->enter(0, Half::upper);
  walk->leave();
  EXPECT_EQ(walk->bound(whole), at_whole);
}

TEST_P(RangeBoundContract, ConvergesToTheValueOnSmallBoxes) {
  auto graph = std::make_shared<ExpressionGraph>();
  const Expression f = parse_expression(*graph, "x^2*y - 3*x + 1/7", names(2));
  const auto bound = make(BoundTarget(graph, f, 2));
  const double h = 0x1p-20;
  const Interval range = bound->over({{1 - h, 1 + h}, {2 - h, 2 + h}});
  EXPECT_LT(width(range), 20 * h);
  EXPECT_TRUE(contains(range, -1.0 + 1.0 / 7));
}

TEST_P(RangeBoundContract, TranscendentalFunctionsAreEnclosedOrRefusedWithAReason) {
  const std::vector<std::string> functions = {"exp(x)*sin(3*y) - y",   "sqrt(x + 3)*cos(x*y)",
                                              "log(x + 5)/(y + 4)",    "atan(x*y) + cbrt(x - y)",
                                              "x^(2/3) - asin(y/4)*x", "tan(x/3) + acos(y/3)",
                                              "exp(-x^2 - y^2)*(x+y)", "log(4 + sin(x)) - sqrt(y^2)"};
  if (!takes_transcendental()) {
    auto graph = std::make_shared<ExpressionGraph>();
    try {
      static_cast<void>(make(BoundTarget(graph, parse_expression(*graph, "x + sin(y)", names(2)), 2)));
      FAIL() << "expected NotApplicable";
    } catch (const NotApplicable& reason) {
      EXPECT_NE(std::string(reason.what()).find("sin"), std::string::npos) << reason.what();
    }
    return;
  }
  Random random(fuzz_seed(), "range_bound_transcendental");
  for (const std::string& text : functions) {
    auto graph = std::make_shared<ExpressionGraph>();
    const Expression f = parse_expression(*graph, text, names(2));
    const auto bound = make(BoundTarget(graph, f, 2));
    const Tape tape(f, 2);
    for (std::size_t cases = 0; cases < fuzz_cases(10000) / functions.size(); cases += 5) {
      Box box;
      for (int i = 0; i < 2; ++i) {
        const double a = random.uniform(-3, 3), size = random.uniform(0, 1);
        box.emplace_back(a, a + size * size);
      }
      const Interval range = bound->over(box);
      for (int p = 0; p < 5; ++p) {
        const std::vector<Rational> point = random_member(random, box);
        const NumberTraits<MpfrInterval>::Scope scope(160);
        TapeEvaluator<MpfrInterval> evaluator(tape);
        std::vector<MpfrInterval> values;
        for (const Rational& coordinate : point)
          values.push_back(NumberTraits<MpfrInterval>::from_rational(coordinate));
        evaluator.evaluate(values);
        const Interval value = NumberTraits<MpfrInterval>::enclosure(evaluator.value());
        if (is_empty(value)) continue;  // not defined there
        ASSERT_FALSE(disjoint(range, value))
            << text << ": " << to_string(range) << " misses " << to_string(value);
      }
    }
  }
}

TEST_P(RangeBoundContract, DomainsThatEndInTheBoxLoseNothing) {
  if (!takes_transcendental()) GTEST_SKIP() << "takes polynomials only";
  auto graph = std::make_shared<ExpressionGraph>();
  // Defined for x >= 1/4 only; the middle of the box lies outside the domain, where a mean value form has no
  // centre.
  const Expression f = parse_expression(*graph, "sqrt(x - 1/4) - 1/8", names(1));
  const auto bound = make(BoundTarget(graph, f, 1));
  EXPECT_TRUE(contains(bound->over({{-1, 0.5}}), 0.375));  // x = 1/2
  EXPECT_TRUE(contains(bound->over({{-1, 0.265625}}), 0));
  EXPECT_TRUE(is_empty(bound->over({{-2, -1}})));
}

INSTANTIATE_TEST_SUITE_P(Bounds, RangeBoundContract, testing::ValuesIn(rigorous_choices()), name_of_choice);

TEST(RangeBoundBaseline, UnroundedArithmeticLosesAZero) {
  // 3 fl(1/10) rounds to the neighbour of fl(3/10), so a function that is identically 0 seems not to vanish
  // at 1.
  auto graph = std::make_shared<ExpressionGraph>();
  const Expression f = parse_expression(*graph, "x*(1/10)*3 - x*(3/10)", names(1));  // identically 0
  const BoundTarget target(graph, f, 1);
  const auto bound_with = [&](const char* arithmetic) {
    const BoundVariant& natural = bound_registry().at("natural");
    return natural.make(target, Options(natural.options, {{"arithmetic", arithmetic}}, "natural"))
        ->over({{1, 1}});
  };
  EXPECT_FALSE(contains(bound_with("unrounded"), 0));
  for (const char* rigorous : {"fast", "boost", "mpfr"}) EXPECT_TRUE(contains(bound_with(rigorous), 0));
}

}  // namespace
}  // namespace gcslab
