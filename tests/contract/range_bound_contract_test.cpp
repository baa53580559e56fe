// One suite for every registered range bound: a new bound is tested without an edit here.

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/random.h"
#include "enclosure/bound_registry.h"
#include "expression/parser.h"
#include "expression/tape_evaluator.h"
#include "interval/arithmetic.h"
#include "support/fuzz.h"

namespace gcslab {
namespace {

/// A registered bound with one choice of arithmetic.
struct BoundChoice {
  std::string bound;
  std::string arithmetic;  ///< empty when the bound has no such option

  const BoundVariant& variant() const { return bound_registry().at(bound); }
  Options options() const {
    std::map<std::string, std::string> given;
    if (!arithmetic.empty()) given["arithmetic"] = arithmetic;
    if (arithmetic == "mpfr") given["bits"] = "80";
    return Options(variant().options, given, bound);
  }
};

/// All rigorous choices.
std::vector<BoundChoice> rigorous_choices() {
  std::vector<BoundChoice> choices;
  for (const BoundVariant& variant : bound_registry().entries()) {
    std::vector<std::string> arithmetics = {""};
    for (const OptionSpec& option : variant.options) {
      if (option.name == "arithmetic") arithmetics = option.choices;
    }
    for (const std::string& arithmetic : arithmetics) {
      const BoundChoice choice{variant.name, arithmetic};
      if (variant.promise(choice.options()) == Promise::rigorous) choices.push_back(choice);
    }
  }
  return choices;
}

std::string name_of_choice(const testing::TestParamInfo<BoundChoice>& info) {
  return info.param.bound + (info.param.arithmetic.empty() ? "" : "_" + info.param.arithmetic);
}

std::vector<std::string> names(int variables) {
  const std::vector<std::string> all = {"x", "y", "z"};
  return {all.begin(), all.begin() + variables};
}

/// A random polynomial of low degree as an expression that mixes sums, products and powers.
Expression random_expression(ExpressionGraph& graph, Random& random, int variables, int depth) {
  const auto leaf = [&]() -> Expression {
    if (random.below(3) == 0) return graph.constant(Rational(random.integer(-40, 40), random.integer(1, 12)));
    return graph.variable(static_cast<int>(random.below(static_cast<std::uint64_t>(variables))));
  };
  if (depth == 0) return leaf();
  const Expression a = random_expression(graph, random, variables, depth - 1);
  switch (random.below(6)) {
    case 0:
      return a + random_expression(graph, random, variables, depth - 1);
    case 1:
      return a - random_expression(graph, random, variables, depth - 1);
    case 2:
    case 3:
      return a * random_expression(graph, random, variables, depth - 1);
    case 4:
      return pow(a, static_cast<int>(random.integer(2, 3)));
    default:
      return -a + leaf();
  }
}

double random_end(Random& random) {
  switch (random.below(4)) {
    case 0:
      return static_cast<double>(random.integer(-3, 3));
    case 1:
      return random.uniform(-1, 1) * 1e-8;
    case 2:
      return random.uniform(-50, 50);
    default:
      return random.uniform(-2, 2);
  }
}

Box random_box(Random& random, int variables) {
  Box box;
  for (int i = 0; i < variables; ++i) {
    const double a = random_end(random);
    const double b = random.below(8) == 0 ? a : random_end(random);
    box.emplace_back(std::min(a, b), std::max(a, b));
  }
  return box;
}

/// A rational point of the box: a corner now and then, else a point between.
std::vector<Rational> random_member(Random& random, const Box& box) {
  std::vector<Rational> point;
  for (const Interval& side : box) {
    const Rational lower = rational_from_double(side.lower), upper = rational_from_double(side.upper);
    const std::int64_t steps = random.below(4) == 0 ? 1 : 97;
    Rational t(random.integer(0, steps), steps);
    t.canonicalize();
    point.push_back(lower + (upper - lower) * t);
  }
  return point;
}

Rational exact_value(const Tape& tape, const std::vector<Rational>& point) {
  TapeEvaluator<Rational> evaluator(tape);
  evaluator.evaluate(point);
  return evaluator.value();
}

bool encloses(const Interval& bound, const Rational& value) {
  const bool above = bound.lower == Interval::entire().lower || rational_from_double(bound.lower) <= value;
  const bool below = bound.upper == Interval::entire().upper || value <= rational_from_double(bound.upper);
  return above && below;
}

class RangeBoundContract : public testing::TestWithParam<BoundChoice> {
 protected:
  std::unique_ptr<RangeBound> make(const BoundTarget& target) const {
    return GetParam().variant().make(target, GetParam().options());
  }
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

TEST_P(RangeBoundContract, EnclosesExactValuesOfRandomPolynomials) {
  constexpr int kBoxes = 8, kPoints = 5;
  Random random(fuzz_seed(), "range_bound_contract");
  for (std::size_t cases = 0; cases < fuzz_cases(10000); cases += kBoxes * kPoints) {
    const int variables = static_cast<int>(random.integer(1, 3));
    auto graph = std::make_shared<ExpressionGraph>();
    const Expression f = random_expression(*graph, random, variables, 3);
    const Tape tape(f, variables);
    const auto bound = make(BoundTarget(graph, f, variables));
    for (int b = 0; b < kBoxes; ++b) {
      const Box box = random_box(random, variables);
      const Interval range = bound->over(box);
      for (int p = 0; p < kPoints; ++p) {
        const std::vector<Rational> point = random_member(random, box);
        ASSERT_TRUE(encloses(range, exact_value(tape, point))) << to_string(range) << " seed " << fuzz_seed();
      }
    }
  }
}

TEST_P(RangeBoundContract, WalksEncloseExactValuesOnTheBoxesTheyReach) {
  constexpr int kDepth = 12, kPoints = 4;
  Random random(fuzz_seed(), "range_bound_walk");
  for (std::size_t cases = 0; cases < fuzz_cases(10000); cases += kDepth * kPoints) {
    const int variables = static_cast<int>(random.integer(1, 3));
    auto graph = std::make_shared<ExpressionGraph>();
    const Expression f = random_expression(*graph, random, variables, 3);
    const Tape tape(f, variables);
    const auto bound = make(BoundTarget(graph, f, variables));
    Box box = random_box(random, variables);
    const auto walk = bound->walk(box, kDepth);
    for (int level = 0; level < kDepth; ++level) {
      const std::size_t variable = random.below(static_cast<std::uint64_t>(variables));
      const Half half = random.below(2) == 0 ? Half::lower : Half::upper;
      const double middle = midpoint(box[variable]);
      (half == Half::lower ? box[variable].upper : box[variable].lower) = middle;
      walk->enter(variable, half);
      const Interval range = walk->bound(box);
      const bool no_zero = walk->excludes_zero(box);
      for (int p = 0; p < kPoints; ++p) {
        const Rational value = exact_value(tape, random_member(random, box));
        ASSERT_TRUE(encloses(range, value)) << to_string(range) << " seed " << fuzz_seed();
        ASSERT_FALSE(no_zero && value == 0);
      }
    }
  }
}

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
    for (std::size_t cases = 0; cases < fuzz_cases(10000) / 8; cases += 5) {
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
