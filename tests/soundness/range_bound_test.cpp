// Every registered bound, in every rigorous arithmetic, encloses the exact values of random polynomials. An
// exact value is computed once and compared with the intersection of all bounds: it lies in each of them when
// it lies in that.

#include <array>
#include <cmath>
#include <gtest/gtest.h>

#include "base/error.h"
#include "base/random.h"
#include "expression/printer.h"
#include "interval/mpfr_interval.h"
#include "support/fuzz.h"
#include "support/range_bound_cases.h"

namespace gcslab {
namespace {

using namespace bound_cases;

/// A random polynomial with all bounds of it.
struct RandomFunction {
  std::shared_ptr<ExpressionGraph> graph = std::make_shared<ExpressionGraph>();
  int variables;
  Expression function;
  Tape tape;
  std::vector<std::unique_ptr<RangeBound>> bounds;

  RandomFunction(Random& random, const std::vector<BoundChoice>& choices)
      : variables(static_cast<int>(random.integer(1, 3))),
        function(random_expression(*graph, random, variables, 3)),
        tape(function, variables) {
    const BoundTarget target(graph, function, variables);
    for (const BoundChoice& choice : choices) bounds.push_back(choice.make(target));
  }
};

/// Compares the ranges, one a choice, with exact values at random points of the box.
void check_ranges(const std::vector<BoundChoice>& choices, const std::vector<Interval>& ranges,
                  const Tape& tape, const Box& box, Random& random, int points) {
  Interval common = Interval::entire();
  for (const Interval& range : ranges) common = intersection(common, range);
  for (int p = 0; p < points; ++p) {
    const Rational value = exact_value(tape, random_member(random, box));
    if (encloses(common, value)) continue;
    for (std::size_t i = 0; i < choices.size(); ++i) {
      ASSERT_TRUE(encloses(ranges[i], value))
          << choices[i].name() << " gives " << to_string(ranges[i]) << ", which misses " << value.get_str()
          << "; seed " << fuzz_seed();
    }
  }
}

void expect_one_sign(const Tape& tape, const Box& box, Random& random, int points) {
  const int sign = sgn(exact_value(tape, random_member(random, box)));
  EXPECT_NE(sign, 0);
  for (int p = 1; p < points; ++p) EXPECT_EQ(sgn(exact_value(tape, random_member(random, box))), sign);
}

TEST(RangeBoundSoundness, BoundsOverBoxesEncloseExactValues) {
  constexpr int kBoxes = 4, kPoints = 25;
  const std::vector<BoundChoice> choices = rigorous_choices();
  Random random(fuzz_seed(), "range_bound_over");
  for (std::size_t cases = 0; cases < fuzz_cases(50'000) / 2; cases += std::size_t{kBoxes} * kPoints) {
    const RandomFunction f(random, choices);
    for (int b = 0; b < kBoxes; ++b) {
      const Box box = random_box(random, f.variables);
      std::vector<Interval> ranges;
      for (const auto& bound : f.bounds) ranges.push_back(bound->over(box));
      check_ranges(choices, ranges, f.tape, box, random, kPoints);
      if (HasFatalFailure()) return;
    }
  }
}

TEST(RangeBoundSoundness, BoundsAlongWalksEncloseExactValues) {
  constexpr int kDepth = 12, kPoints = 10;
  const std::vector<BoundChoice> choices = rigorous_choices();
  Random random(fuzz_seed(), "range_bound_walk");
  for (std::size_t cases = 0; cases < fuzz_cases(50'000) / 2; cases += std::size_t{kDepth} * kPoints) {
    const RandomFunction f(random, choices);
    Box box = random_box(random, f.variables);
    std::vector<std::unique_ptr<BoundWalk>> walks;
    for (const auto& bound : f.bounds) walks.push_back(bound->walk(box, kDepth));
    for (int level = 0; level < kDepth; ++level) {
      const std::size_t variable = random.below(static_cast<std::uint64_t>(f.variables));
      const Half half = random.below(2) == 0 ? Half::lower : Half::upper;
      const double middle = midpoint(box[variable]);
      (half == Half::lower ? box[variable].upper : box[variable].lower) = middle;
      std::vector<Interval> ranges;
      bool excluded = false;
      for (const auto& walk : walks) {
        walk->enter(variable, half);
        const Interval range = walk->bound(box);
        excluded = excluded || walk->excludes_zero(box);
        ranges.push_back(range);
      }
      check_ranges(choices, ranges, f.tape, box, random, kPoints);
      if (HasFatalFailure()) return;
      // A polynomial without a zero on a box has one sign there.
      if (excluded) expect_one_sign(f.tape, box, random, kPoints);
    }
  }
}

/// A random expression over all operations: partial domains, kinks and infinite derivatives included.
Expression random_transcendental(ExpressionGraph& graph, Random& random, int depth) {
  if (depth == 0) {
    if (random.below(3) == 0)
      return graph.constant(Rational(random.integer(-12, 12)) / Rational(random.integer(1, 6)));
    return graph.variable(static_cast<int>(random.below(2)));
  }
  const Expression a = random_transcendental(graph, random, depth - 1);
  const auto b = [&] { return random_transcendental(graph, random, depth - 1); };
  static constexpr std::array kFunctions = {Operation::sqrt, Operation::cbrt, Operation::exp, Operation::log,
                                            Operation::sin,  Operation::cos,  Operation::tan, Operation::asin,
                                            Operation::acos, Operation::atan, Operation::abs};
  try {
    switch (random.below(12)) {
      case 0:
      case 1:
        return a + b();
      case 2:
        return a - b();
      case 3:
      case 4:
        return a * b();
      case 5:
        return a / b();
      case 6:
        return graph.apply(Operation::min, a, b());
      case 7:
        return graph.apply(Operation::max, a, b());
      case 8:
        return graph.power(a, Rational(random.integer(-2, 4)));
      case 9: {
        Rational exponent(random.integer(-3, 3), random.integer(2, 3));
        exponent.canonicalize();
        return graph.power(a, exponent);
      }
      default:
        return graph.apply(kFunctions[random.below(kFunctions.size())], a);
    }
  } catch (const InputError&) {  // division by the constant 0
    return a;
  }
}

/// A box around the places where functions have kinks and domains end; sometimes flat.
Box random_box_at_kinks(Random& random) {
  Box box;
  for (int i = 0; i < 2; ++i) {
    const double centre =
        random.below(2) == 0 ? static_cast<double>(random.integer(-2, 2)) : random.uniform(-3, 3);
    const double size =
        random.below(5) == 0 ? 0 : std::ldexp(random.uniform(0.5, 1), -static_cast<int>(random.below(12)));
    const std::uint64_t side = random.below(3);
    box.emplace_back(side == 0 ? centre : centre - size, side == 1 ? centre : centre + size);
  }
  return box;
}

/// The value at a point to 160 bits; empty where f is not surely defined.
Interval accurate_value(const Tape& tape, const std::vector<Rational>& point) {
  const NumberTraits<MpfrInterval>::Scope scope(160);
  TapeEvaluator<MpfrInterval> evaluator(tape);
  std::vector<MpfrInterval> arguments;
  for (const Rational& coordinate : point)
    arguments.push_back(NumberTraits<MpfrInterval>::from_rational(coordinate));
  evaluator.evaluate(arguments);
  return evaluator.defined_everywhere() ? NumberTraits<MpfrInterval>::enclosure(evaluator.value())
                                        : Interval();
}

TEST(RangeBoundSoundness, BoundsOfRandomTranscendentalFunctionsEncloseAccurateValues) {
  constexpr int kBoxes = 4, kPoints = 10;
  const std::vector<BoundChoice> choices = rigorous_choices();
  Random random(fuzz_seed(), "range_bound_transcendental");
  std::size_t compared = 0;
  while (compared < fuzz_cases(20'000)) {
    auto graph = std::make_shared<ExpressionGraph>();
    const Expression function = random_transcendental(*graph, random, static_cast<int>(random.integer(2, 4)));
    const BoundTarget target(graph, function, 2);
    const Tape tape(function, 2);
    std::vector<std::pair<std::string, std::unique_ptr<RangeBound>>> bounds;
    for (const BoundChoice& choice : choices) {
      if (choice.bound == "exact") continue;  // polynomials only, and slow on steep ones
      try {
        bounds.emplace_back(choice.name(), choice.make(target));
      } catch (const NotApplicable&) {
      }
    }
    for (int b = 0; b < kBoxes; ++b) {
      const Box box = random_box_at_kinks(random);
      std::vector<Interval> ranges;
      for (const auto& [name, bound] : bounds) ranges.push_back(bound->over(box));
      for (int p = 0; p < kPoints; ++p) {
        const Interval value = accurate_value(tape, random_member(random, box));
        if (is_empty(value)) continue;
        ++compared;
        for (std::size_t i = 0; i < ranges.size(); ++i) {
          ASSERT_FALSE(disjoint(ranges[i], value))
              << bounds[i].first << " of " << to_text(function, std::vector<std::string>{"x", "y"}) << " on "
              << to_string(box[0]) << " x " << to_string(box[1]) << " gives " << to_string(ranges[i])
              << ", which misses " << to_string(value) << "; seed " << fuzz_seed();
        }
      }
    }
  }
}

}  // namespace
}  // namespace gcslab
