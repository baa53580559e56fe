// Every registered bound, in every rigorous arithmetic, encloses the exact values of random polynomials. An
// exact value is computed once and compared with the intersection of all bounds: it lies in each of them when
// it lies in that.

#include <gtest/gtest.h>

#include "base/random.h"
#include "support/fuzz.h"
#include "support/range_bound_cases.h"

namespace gcslab {
namespace {

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

TEST(RangeBoundSoundness, BoundsOverBoxesEncloseExactValues) {
  constexpr int kBoxes = 4, kPoints = 25;
  const std::vector<BoundChoice> choices = rigorous_choices();
  Random random(fuzz_seed(), "range_bound_over");
  for (std::size_t cases = 0; cases < fuzz_cases(50'000); cases += kBoxes * kPoints) {
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
  for (std::size_t cases = 0; cases < fuzz_cases(50'000); cases += kDepth * kPoints) {
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
      for (const auto& walk : walks) {
        walk->enter(variable, half);
        const Interval range = walk->bound(box);
        // What the walk says of zeros is a bound too: all but 0.
        if (contains(range, 0)) {
          ASSERT_FALSE(walk->excludes_zero(box) && exact_value(f.tape, random_member(random, box)) == 0);
        }
        ranges.push_back(range);
      }
      check_ranges(choices, ranges, f.tape, box, random, kPoints);
      if (HasFatalFailure()) return;
    }
  }
}

}  // namespace
}  // namespace gcslab
