// Every registered constraint, on random figures: its equations hold for the parameter read off a figure and
// for no other, take as many degrees of freedom as it says, and say the same of a figure that is moved.

#include "geometry/constraint_kind.h"

#include <cmath>
#include <gtest/gtest.h>

#include "geometry/figure_projection.h"
#include "support/error_text.h"
#include "support/fuzz.h"
#include "unit/geometry/constraint_case.h"
#include "unit/geometry/isometry.h"

namespace gcslab {
namespace {

class ConstraintKindContract : public testing::TestWithParam<ConstraintCase> {
 protected:
  const ConstraintKind& kind() const { return *GetParam().kind; }
};

TEST_P(ConstraintKindContract, DescribesItself) {
  EXPECT_GT(kind().summary.size(), 5U);
  EXPECT_FALSE(kind().sorts.empty());
  for (const Sort sort : kind().sorts) EXPECT_TRUE(exists_in(sort, GetParam().universe));
  EXPECT_FALSE(kind().interpretations.empty());
  for (const Interpretation& interpretation : kind().interpretations)
    EXPECT_FALSE(interpretation.summary.empty());
  EXPECT_TRUE(kind().nearness == Nearness::unknown || kind().sorts.size() == 2);
  EXPECT_TRUE(kind().nearness != Nearness::parameter || kind().is_metric());
  if (kind().is_metric()) return;
  EXPECT_TRUE(kind().metric_form.empty() || constraint_registry().at(kind().metric_form).is_metric());
}

TEST_P(ConstraintKindContract, HasAsManyEquationsAsItTakesDegreesOfFreedom) {
  for (std::size_t i = 0; i < kind().interpretations.size(); ++i) {
    const GeometricEquations equations = geometric_equations(system_of(GetParam(), i), {});
    const auto own =
        std::ranges::count_if(equations.constraint_of_equation, [](const auto& c) { return c.has_value(); });
    EXPECT_EQ(own - static_cast<int>(equations.auxiliaries), kind().restriction(GetParam().universe));
  }
}

/// An object has as many degrees of freedom as unknowns less normalising equations.
TEST_P(ConstraintKindContract, NormalisesItsObjects) {
  const auto degrees_of_freedom = [&](Sort sort) {
    const bool is_plane = GetParam().universe == Universe::plane;
    switch (sort) {
      case Sort::point:
        return is_plane ? 2 : 3;
      case Sort::line:
        return is_plane ? 2 : 4;
      case Sort::plane:
        return 3;
      case Sort::circle:
        return is_plane ? 3 : 6;
      case Sort::sphere:
        return 4;
    }
    return 0;
  };
  const GeometricEquations equations = geometric_equations(system_of(GetParam()), {});
  int expected = 0;
  for (const Sort sort : kind().sorts) expected += degrees_of_freedom(sort);
  const auto normalising =
      std::ranges::count_if(equations.constraint_of_equation, [](const auto& c) { return !c.has_value(); });
  EXPECT_EQ(static_cast<int>(equations.unknowns.size() - equations.auxiliaries) - normalising, expected);
}

TEST_P(ConstraintKindContract, HoldsForTheParameterThatAFigureShows) {
  if (!kind().is_metric()) GTEST_SKIP() << "no parameter";
  Random random(fuzz_seed(), "constraint kinds");
  for (std::size_t i = 0; i < kind().interpretations.size(); ++i) {
    const ConstraintSystem system = system_of(GetParam(), i);
    const GeometricEquations equations = geometric_equations(system, {});
    for (std::size_t n = 0; n < fuzz_cases(200); ++n) {
      const Figure figure = random_figure(system, random);
      const double parameter = parameters_of(system, figure)[0];
      ASSERT_TRUE(contains(kind().possible, parameter)) << parameter;
      std::vector<double> numbers = flat(figure);
      numbers.push_back(parameter);
      for (const double value : values_at(equations, numbers)) ASSERT_NEAR(value, 0, 1e-13);
      const bool is_small = contains(kind().possible, parameter + 0.25);  // and for no other
      numbers.back() = is_small ? parameter + 0.25 : parameter - 0.25;
      double largest = 0;
      for (const double value : values_at(equations, numbers)) largest = std::max(largest, std::abs(value));
      ASSERT_GT(largest, 1e-6);
    }
  }
}

TEST_P(ConstraintKindContract, IsNotChangedByIsometries) {
  if (kind().name.starts_with("fixed")) GTEST_SKIP() << "about coordinates";
  Random random(fuzz_seed(), "constraint kinds moved");
  const ConstraintSystem system = system_of(GetParam());
  const GeometricEquations equations = geometric_equations(system, {});
  std::size_t compared = 0;
  for (std::size_t n = 0; n < fuzz_cases(100); ++n) {
    const std::vector<double> unknowns = unknowns_of(equations, random_figure(system, random));
    const FigureProjection first = satisfy_common_equations(system, equations, unknowns);
    if (!first.holds) continue;  // no figure near by has what a boolean one says
    ++compared;
    const Figure figure = figure_at(equations, first.unknowns);
    const Figure moved = randomly_moved(kind().sorts, GetParam().universe, figure, random);
    const std::vector<double> coordinates = unknowns_of(equations, moved);
    const FigureProjection again = satisfy_common_equations(system, equations, coordinates);
    ASSERT_TRUE(again.holds);
    const std::size_t last = coordinates.size() - equations.auxiliaries;
    for (std::size_t i = 0; i < last; ++i) ASSERT_NEAR(again.unknowns[i], coordinates[i], 1e-6);
    if (!kind().is_metric()) continue;  // of the area and the volume the sign may change
    ASSERT_NEAR(std::abs(parameters_of(system, figure)[0]), std::abs(parameters_of(system, moved)[0]), 1e-7);
  }
  EXPECT_GT(compared, fuzz_cases(100) / 2);
}

TEST_P(ConstraintKindContract, SaysThatItIsNotSmoothWhereObjectsMeet) {
  for (const Interpretation& interpretation : kind().interpretations) {
    if (interpretation.not_smooth_at == nullptr) continue;
    ExpressionGraph graph;
    ConstraintPlace together{GetParam().universe, {}};
    for (const Sort sort : kind().sorts) {
      Vector coordinates;
      for (const CoordinateName& name : coordinate_names(sort, GetParam().universe)) {
        const bool is_along = name.role == Role::direction && !name.suffix.ends_with("x");
        coordinates.push_back(graph.constant(is_along ? 0 : 1));
      }
      together.objects.push_back(parts_of(sort, GetParam().universe, coordinates));
    }
    for (const Expression& size : interpretation.not_smooth_at(together)) EXPECT_TRUE(size.is_constant(0));
  }
}

INSTANTIATE_TEST_SUITE_P(Registered, ConstraintKindContract, testing::ValuesIn(all_constraint_cases()),
                         [](const auto& of) { return name_of(of.param); });

TEST(ConstraintRegistry, HasNoTwoKindsOfAWordForTheSameSorts) {
  for (const std::string& name : constraint_registry().names()) {
    const auto kinds = constraint_registry().kinds(name);
    EXPECT_EQ(kinds.front(), &constraint_registry().at(name));
    for (std::size_t i = 0; i < kinds.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) EXPECT_NE(kinds[i]->sorts, kinds[j]->sorts) << name;
    }
  }
  EXPECT_TRUE(constraint_registry().kinds("banana").empty());
  EXPECT_NE(error_text([] { static_cast<void>(constraint_registry().at("distanze")); }).find("distance"),
            std::string::npos);
}

}  // namespace
}  // namespace gcslab
