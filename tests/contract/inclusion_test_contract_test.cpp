// One suite for every registered inclusion test in every rigorous arithmetic: what it claims is true of
// systems all of whose roots are known, with clusters, double roots and systems without roots but nearly so.
// The guesses that it is given are good, poor or nonsense. A new test is tested without an edit here.

#include <algorithm>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "base/error.h"
#include "certification/inclusion_test.h"
#include "support/counted_system.h"
#include "support/fuzz.h"

namespace gcslab {
namespace {

using planted::CountedGenerator;
using planted::CountedSystem;
using planted::PlantedGenerator;
using planted::Point;

struct Choice {
  std::string test;
  Arithmetic arithmetic;

  const InclusionTestVariant& variant() const { return inclusion_test_registry().at(test); }
  std::unique_ptr<InclusionTest> make(const SystemFunctions& functions) const {
    return variant().make(functions, {arithmetic, arithmetic == Arithmetic::mpfr ? 90 : 53});
  }
};

std::vector<Choice> choices() {
  std::vector<Choice> result;
  for (const std::string& name : inclusion_test_registry().names()) {
    for (const Arithmetic arithmetic : kArithmetics) {
      if (promise_of(arithmetic) == Promise::rigorous) result.push_back({name, arithmetic});
    }
  }
  return result;
}

std::string name_of_choice(const testing::TestParamInfo<Choice>& info) {
  return info.param.test + "_" + std::string(name_of(info.param.arithmetic));
}

/// A guess near the centre of the box or elsewhere, with the inverse of the Jacobian there or something else.
ApproximateRoot guess(Random& random, const SystemFunctions& functions, const Box& box, const Point& centre) {
  const NumberTraits<double>::Scope scope;
  const std::size_t n = box.size();
  ApproximateRoot result;
  for (std::size_t i = 0; i < n; ++i) {
    const double noise = random.below(3) == 0 ? random.uniform(-1, 1) * width(box[i]) : 0;
    result.point.push_back(random.below(4) == 0 ? midpoint(box[i]) : nearest_double(centre[i]) + noise);
  }
  SystemEvaluator<double> evaluator(functions);
  Matrix<double> jacobian(n, n);
  static_cast<void>(evaluator.jacobian(result.point, jacobian));
  const auto inverse = approximate_inverse(jacobian);
  result.inverse = inverse ? *inverse : Matrix<double>(n, n, 1);
  if (random.below(8) == 0) result.inverse(random.below(n), random.below(n)) += random.uniform(-1, 1);
  if (random.below(30) == 0) result.inverse.fill(0);
  return result;
}

/// Bounded, around the centre.
Box bounded_box(Random& random, PlantedGenerator& generator, const Point& centre) {
  Box box = generator.box_around(centre);
  for (Interval& side : box) side = Interval(std::max(side.lower, -1e9), std::min(side.upper, 1e9));
  const double grown = random.below(2) == 0 ? 0 : 1e-3;
  for (Interval& side : box) side = Interval(side.lower - grown, side.upper + grown);
  return box;
}

bool is_true(Claim claim, std::size_t roots) {
  if (claim == Claim::unique) return roots == 1;
  return claim == Claim::exists ? roots >= 1 : roots <= 1;
}

class InclusionTestContract : public testing::TestWithParam<Choice> {};

TEST_P(InclusionTestContract, ClaimsWhatIsTrue) {
  constexpr std::size_t kBoxes = 10;
  const std::size_t cases = fuzz_cases(5000) / (GetParam().arithmetic == Arithmetic::fast ? 1 : 5);
  Random random(fuzz_seed(), "inclusion_test_contract");
  CountedGenerator systems(random);
  PlantedGenerator boxes(random);
  std::size_t proofs = 0;
  for (std::size_t i = 0; i < cases; i += kBoxes) {
    const CountedSystem counted = systems.system(static_cast<int>(random.integer(1, 3)));
    const SystemFunctions functions(counted.system);
    const auto test = GetParam().make(functions);
    for (std::size_t k = 0; k < kBoxes; ++k) {
      const Point& centre = counted.centres[random.below(counted.centres.size())];
      const Box box = bounded_box(random, boxes, centre);
      const auto evidence = test->prove(box, guess(random, functions, box, centre));
      if (!evidence) continue;
      ++proofs;
      ASSERT_EQ(evidence->claim, GetParam().variant().claim);
      ASSERT_EQ(evidence->type, GetParam().test);
      ASSERT_EQ(evidence->box, box);
      const auto roots = std::ranges::count_if(
          counted.roots, [&](const Point& root) { return planted::contains(box, root); });
      ASSERT_TRUE(is_true(evidence->claim, static_cast<std::size_t>(roots)))
          << planted::to_text(counted.system) << "has " << roots << " roots in " << planted::to_text(box);
    }
  }
  // A test that never proves anything would pass all that.
  EXPECT_GT(proofs, cases / 20);
}

ApproximateRoot guess_at(const SystemFunctions& functions, const std::vector<double>& point) {
  const NumberTraits<double>::Scope scope;
  SystemEvaluator<double> evaluator(functions);
  Matrix<double> jacobian(point.size(), point.size());
  EXPECT_TRUE(evaluator.jacobian(point, jacobian));
  const auto inverse = approximate_inverse(jacobian);
  return {point, inverse ? *inverse : Matrix<double>(point.size(), point.size(), 1)};
}

TEST_P(InclusionTestContract, ProvesARegularRoot) {
  const SystemFunctions functions(planted::system_of({"x", "y"}, {"x^2 + y^2 - 2", "exp(x - y) - 1"}));
  const auto test = GetParam().make(functions);
  EXPECT_TRUE(test->prove({{0.95, 1.04}, {0.96, 1.05}}, guess_at(functions, {1, 1.001})).has_value());
}

TEST_P(InclusionTestContract, ProvesNothingOfADoubleRootOrANearMiss) {
  for (const char* text : {"x^2", "x^2 + 1e-12"}) {
    const SystemFunctions functions(planted::system_of({"x"}, {text}));
    const auto test = GetParam().make(functions);
    for (const double size : {1e-9, 1e-6, 1e-5, 1e-3, 1.0}) {
      for (const double point : {0.0, 1e-7, size / 2, -size}) {
        EXPECT_FALSE(test->prove({{-size, size}}, guess_at(functions, {point})).has_value()) << text;
      }
    }
  }
}

TEST_P(InclusionTestContract, ProvesNothingWhereAnEquationMayBeUndefined) {
  // Continuous up to x = 0 and undefined beyond: the sign of the rest of the box means nothing.
  const SystemFunctions functions(planted::system_of({"x"}, {"sqrt(x) + x - 1/8"}));
  const auto test = GetParam().make(functions);
  EXPECT_FALSE(test->prove({{-0.5, 0.5}}, guess_at(functions, {0.0139})).has_value());
}

TEST_P(InclusionTestContract, RefusesWhatItCannotTake) {
  const auto refuses = [](const EquationSystem& system, Arithmetic arithmetic) {
    const SystemFunctions functions(system);
    try {
      static_cast<void>(GetParam().variant().make(functions, {arithmetic, 53}));
      return false;
    } catch (const NotApplicable& reason) {
      return std::string(reason.what()).size() > 10;
    }
  };
  EXPECT_TRUE(refuses(planted::system_of({"x", "y"}, {"x + y"}), Arithmetic::fast));
  EXPECT_TRUE(refuses(planted::system_of({"x"}, {"x - 1"}), Arithmetic::unrounded));
  EXPECT_FALSE(refuses(planted::system_of({"x"}, {"x - 1"}), Arithmetic::fast));
}

INSTANTIATE_TEST_SUITE_P(Every, InclusionTestContract, testing::ValuesIn(choices()), name_of_choice);

}  // namespace
}  // namespace gcslab
