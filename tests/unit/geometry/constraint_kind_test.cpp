// Every registered constraint, on random figures: its equations hold for the parameter read off a figure,
// take as many degrees of freedom as it says, and boolean ones hold on figures made to have what they say.

#include <cmath>
#include <gtest/gtest.h>

#include "base/random.h"
#include "expression/tape_evaluator.h"
#include "geometry/geometric_equations.h"
#include "geometry/sketch.h"
#include "support/fuzz.h"

namespace gcslab {
namespace {

struct Choice {
  const ConstraintKind* kind;
  Universe universe;
};

std::vector<Choice> choices() {
  std::vector<Choice> result;
  for (const ConstraintKind& kind : constraint_registry().entries()) {
    for (const Universe universe : kind.universes) result.push_back({&kind, universe});
  }
  return result;
}

std::string name_of_choice(const testing::TestParamInfo<Choice>& info) {
  return info.param.kind->name + (info.param.universe == Universe::plane ? "_2d" : "_3d");
}

/// A system of this one constraint, without a frame.
ConstraintSystem system_of(const Choice& choice, std::size_t interpretation) {
  ConstraintSystem system;
  system.universe = choice.universe;
  system.frame = Frame();
  Constraint constraint{choice.kind, {}, std::nullopt, interpretation};
  for (std::size_t p = 0; p < choice.kind->points; ++p) {
    system.points.push_back("P" + std::to_string(p));
    constraint.points.push_back(p);
  }
  if (choice.kind->is_metric()) {
    system.parameters.emplace_back("a");
    constraint.parameter = 0;
  }
  system.constraints.push_back(constraint);
  return system;
}

Figure random_figure(const Choice& choice, Random& random) {
  Figure figure(choice.kind->points, std::vector<double>(dimension(choice.universe)));
  for (auto& point : figure) {
    for (double& x : point) x = random.uniform(-1, 1);
  }
  return figure;
}

std::vector<double> values_at(const GeometricEquations& equations, std::vector<double> numbers) {
  const auto variables = static_cast<int>(equations.unknowns.size() + equations.parameters.size());
  const Tape tape(equations.equations, variables);
  TapeEvaluator<double> evaluator(tape);
  evaluator.evaluate(numbers);
  std::vector<double> values;
  for (std::size_t k = 0; k < equations.equations.size(); ++k) values.push_back(evaluator.value(k));
  return values;
}

class ConstraintKindContract : public testing::TestWithParam<Choice> {
 protected:
  static std::vector<double> flat(const Figure& figure) {
    std::vector<double> result;
    for (const auto& point : figure) result.insert(result.end(), point.begin(), point.end());
    return result;
  }
};

TEST_P(ConstraintKindContract, DescribesItself) {
  const ConstraintKind& kind = *GetParam().kind;
  EXPECT_GT(kind.summary.size(), 5U);
  EXPECT_FALSE(kind.interpretations.empty());
  for (const Interpretation& interpretation : kind.interpretations)
    EXPECT_FALSE(interpretation.summary.empty());
  if (kind.is_metric()) return;
  EXPECT_TRUE(kind.metric_form.empty() || constraint_registry().at(kind.metric_form).is_metric());
}

TEST_P(ConstraintKindContract, HasAsManyEquationsAsItTakesDegreesOfFreedom) {
  for (std::size_t i = 0; i < GetParam().kind->interpretations.size(); ++i) {
    const ConstraintSystem system = system_of(GetParam(), i);
    const GeometricEquations equations = geometric_equations(system, {});
    EXPECT_EQ(static_cast<int>(equations.equations.size() - equations.auxiliaries),
              GetParam().kind->restriction(GetParam().universe));
  }
}

TEST_P(ConstraintKindContract, HoldsForTheParameterThatAFigureShows) {
  if (!GetParam().kind->is_metric()) GTEST_SKIP() << "no parameter";
  Random random(fuzz_seed(), "constraint kinds");
  for (std::size_t i = 0; i < GetParam().kind->interpretations.size(); ++i) {
    const ConstraintSystem system = system_of(GetParam(), i);
    const GeometricEquations equations = geometric_equations(system, {});
    for (std::size_t n = 0; n < fuzz_cases(200); ++n) {
      const Figure figure = random_figure(GetParam(), random);
      const double parameter = parameters_of(system, figure)[0];
      ASSERT_TRUE(contains(GetParam().kind->possible, parameter)) << parameter;
      std::vector<double> numbers = flat(figure);
      numbers.push_back(parameter);
      for (const double value : values_at(equations, numbers)) ASSERT_NEAR(value, 0, 1e-13);
      numbers.back() = parameter + 0.25;  // and for no other
      double largest = 0;
      for (const double value : values_at(equations, numbers)) largest = std::max(largest, std::abs(value));
      ASSERT_GT(largest, 1e-6);
    }
  }
}

TEST_P(ConstraintKindContract, SaysThatItIsNotSmoothWherePointsMeet) {
  for (const Interpretation& interpretation : GetParam().kind->interpretations) {
    if (interpretation.not_smooth_at == nullptr) continue;
    ExpressionGraph graph;
    const Vector point(dimension(GetParam().universe), graph.constant(1));
    const ConstraintPlace together{GetParam().universe, std::vector(GetParam().kind->points, point)};
    for (const Expression& size : interpretation.not_smooth_at(together)) EXPECT_TRUE(size.is_constant(0));
  }
}

INSTANTIATE_TEST_SUITE_P(Registered, ConstraintKindContract, testing::ValuesIn(choices()), name_of_choice);

struct Example {
  const char* kind;
  Universe universe;
  Figure holds;
  std::vector<double> auxiliaries;
  Figure fails;
};

const std::vector<Example>& examples() {
  static const std::vector<Example> all = {
      {"collinear", Universe::plane, {{0, 0}, {1, 2}, {3, 6}}, {}, {{0, 0}, {1, 2}, {3, 5}}},
      {"collinear",
       Universe::space,
       {{0, 0, 1}, {1, 2, 1}, {3, 6, 1}},
       {3},
       {{0, 0, 1}, {1, 2, 1}, {3, 6, 2}}},
      {"coplanar",
       Universe::space,
       {{0, 0, 1}, {1, 0, 1}, {0, 2, 1}, {5, 7, 1}},
       {},
       {{0, 0, 1}, {1, 0, 1}, {0, 2, 1}, {5, 7, 2}}},
      {"parallel", Universe::plane, {{0, 0}, {1, 2}, {5, 5}, {3, 1}}, {}, {{0, 0}, {1, 2}, {5, 5}, {3, 2}}},
      {"parallel",
       Universe::space,
       {{0, 0, 0}, {1, 2, 3}, {5, 5, 5}, {3, 1, -1}},
       {-2},
       {{0, 0, 0}, {1, 2, 3}, {5, 5, 5}, {3, 1, 0}}},
      {"perpendicular",
       Universe::plane,
       {{0, 0}, {1, 2}, {5, 5}, {3, 6}},
       {},
       {{0, 0}, {1, 2}, {5, 5}, {3, 7}}},
      {"perpendicular",
       Universe::space,
       {{0, 0, 0}, {1, 2, 3}, {5, 5, 5}, {2, 5, 6}},
       {},
       {{0, 0, 0}, {1, 2, 3}, {5, 5, 5}, {2, 5, 7}}},
      {"equal_lengths",
       Universe::plane,
       {{0, 0}, {3, 4}, {1, 1}, {6, 1}},
       {},
       {{0, 0}, {3, 4}, {1, 1}, {5, 1}}},
      {"equal_lengths",
       Universe::space,
       {{0, 0, 0}, {2, 3, 6}, {1, 1, 1}, {1, 8, 1}},
       {},
       {{0, 0, 0}, {2, 3, 6}, {1, 1, 1}, {1, 7, 1}}}};
  return all;
}

TEST(BooleanConstraints, HoldWhereTheySay) {
  std::size_t booleans = 0;
  for (const ConstraintKind& kind : constraint_registry().entries())
    booleans += kind.is_metric() ? 0U : kind.universes.size();
  EXPECT_EQ(examples().size(), booleans) << "an example each";
  for (const Example& example : examples()) {
    const ConstraintSystem system = system_of({&constraint_registry().at(example.kind), example.universe}, 0);
    const GeometricEquations equations = geometric_equations(system, {});
    const auto largest = [&](const Figure& figure) {
      std::vector<double> numbers;
      for (const auto& point : figure) numbers.insert(numbers.end(), point.begin(), point.end());
      numbers.insert(numbers.end(), example.auxiliaries.begin(), example.auxiliaries.end());
      double result = 0;
      for (const double value : values_at(equations, numbers)) result = std::max(result, std::abs(value));
      return result;
    };
    EXPECT_EQ(largest(example.holds), 0) << example.kind;
    EXPECT_GT(largest(example.fails), 0.1) << example.kind;
  }
}

}  // namespace
}  // namespace gcslab
