// Every boolean constraint, on figures made to have what it says and on figures made not to.

#include <cmath>
#include <gtest/gtest.h>

#include "unit/geometry/constraint_case.h"

namespace gcslab {
namespace {

constexpr Sort P = Sort::point, L = Sort::line, E = Sort::plane, C = Sort::circle, S = Sort::sphere;
constexpr Universe k2 = Universe::plane, k3 = Universe::space;

/// Coordinates as sort.h lists them.
struct Example {
  const char* kind;
  std::vector<Sort> sorts;
  Universe universe;
  Figure holds;
  std::vector<double> auxiliaries;
  Figure fails;
  std::size_t interpretation = 0;
};

const std::vector<Example>& examples_of_points() {
  static const std::vector<Example> all = {
      {"collinear", {P, P, P}, k2, {{0, 0}, {1, 2}, {3, 6}}, {}, {{0, 0}, {1, 2}, {3, 5}}},
      {"collinear", {P, P, P}, k3, {{0, 0, 1}, {1, 2, 1}, {3, 6, 1}}, {3}, {{0, 0, 1}, {1, 2, 1}, {3, 6, 2}}},
      {"coplanar",
       {P, P, P, P},
       k3,
       {{0, 0, 1}, {1, 0, 1}, {0, 2, 1}, {5, 7, 1}},
       {},
       {{0, 0, 1}, {1, 0, 1}, {0, 2, 1}, {5, 7, 2}}},
      {"parallel", {P, P, P, P}, k2, {{0, 0}, {1, 2}, {5, 5}, {3, 1}}, {}, {{0, 0}, {1, 2}, {5, 5}, {3, 2}}},
      {"parallel",
       {P, P, P, P},
       k3,
       {{0, 0, 0}, {1, 2, 3}, {5, 5, 5}, {3, 1, -1}},
       {-2},
       {{0, 0, 0}, {1, 2, 3}, {5, 5, 5}, {3, 1, 0}}},
      {"perpendicular",
       {P, P, P, P},
       k2,
       {{0, 0}, {1, 2}, {5, 5}, {3, 6}},
       {},
       {{0, 0}, {1, 2}, {5, 5}, {3, 7}}},
      {"perpendicular",
       {P, P, P, P},
       k3,
       {{0, 0, 0}, {1, 2, 3}, {5, 5, 5}, {2, 5, 6}},
       {},
       {{0, 0, 0}, {1, 2, 3}, {5, 5, 5}, {2, 5, 7}}},
      {"equal_lengths",
       {P, P, P, P},
       k2,
       {{0, 0}, {3, 4}, {1, 1}, {6, 1}},
       {},
       {{0, 0}, {3, 4}, {1, 1}, {5, 1}}},
      {"equal_lengths",
       {P, P, P, P},
       k3,
       {{0, 0, 0}, {2, 3, 6}, {1, 1, 1}, {1, 8, 1}},
       {},
       {{0, 0, 0}, {2, 3, 6}, {1, 1, 1}, {1, 7, 1}}}};
  return all;
}

/// Directions are axes, or (3, 4) / 5.
const std::vector<Example>& examples_of_incidence() {
  static const std::vector<Example> all = {
      {"incidence", {P, L}, k2, {{3, 1}, {0.6, 0.8, 2.6}}, {}, {{3, 1}, {0.6, 0.8, 3}}},
      {"incidence", {P, L}, k3, {{3, 1, 5}, {3, 1, 0, 0, 0, 1}}, {5}, {{3, 2, 5}, {3, 1, 0, 0, 0, 1}}},
      {"incidence", {P, E}, k3, {{3, 1, 7}, {0.6, 0.8, 0, 2.6}}, {}, {{3, 2, 7}, {0.6, 0.8, 0, 2.6}}},
      {"incidence", {P, C}, k2, {{4, 6}, {1, 2, 5}}, {}, {{4, 6}, {1, 2, 4}}},
      {"incidence",
       {P, C},
       k3,
       {{4, 6, 3}, {1, 2, 3, 0, 0, 1, 5}},
       {},
       {{4, 2, 7}, {1, 2, 3, 0, 0, 1, 5}}},  // on the sphere, not in the plane
      {"incidence", {P, S}, k3, {{3, 5, 9}, {1, 2, 3, 7}}, {}, {{3, 5, 9}, {1, 2, 3, 6}}},
      {"incidence",
       {L, E},
       k3,
       {{3, 1, 0, 0, 0, 1}, {0.6, 0.8, 0, 2.6}},
       {},
       {{3, 0, 0, 0, 0, 1}, {0.6, 0.8, 0, 2.6}}},
      {"centre", {P, C}, k2, {{1, 2}, {1, 2, 5}}, {}, {{1, 3}, {1, 2, 5}}},
      {"centre", {P, C}, k3, {{1, 2, 3}, {1, 2, 3, 0, 1, 0, 5}}, {}, {{1, 2, 4}, {1, 2, 3, 0, 1, 0, 5}}},
      {"centre", {P, S}, k3, {{1, 2, 3}, {1, 2, 3, 5}}, {}, {{0, 2, 3}, {1, 2, 3, 5}}}};
  return all;
}

const std::vector<Example>& examples_of_directions() {
  static const std::vector<Example> all = {
      {"parallel", {L, L}, k2, {{0.6, 0.8, 1}, {-0.6, -0.8, 3}}, {}, {{0.6, 0.8, 1}, {1, 0, 3}}},
      {"parallel",
       {L, L},
       k3,
       {{0, 0, 0, 0.6, 0.8, 0}, {0, 0, 1, -0.6, -0.8, 0}},
       {-1},
       {{0, 0, 0, 0.6, 0.8, 0}, {0, 0, 1, 0.8, 0.6, 0}}},
      {"parallel", {E, E}, k3, {{0.6, 0.8, 0, 1}, {0.6, 0.8, 0, 3}}, {1}, {{0.6, 0.8, 0, 1}, {0, 1, 0, 3}}},
      {"parallel",
       {L, E},
       k3,
       {{0, 0, 4, 0.8, -0.6, 0}, {0.6, 0.8, 0, 1}},
       {},
       {{0, 0, 4, 0.6, 0.8, 0}, {0.6, 0.8, 0, 1}}},
      {"perpendicular", {L, L}, k2, {{0.6, 0.8, 1}, {0.8, -0.6, 3}}, {}, {{0.6, 0.8, 1}, {0, 1, 3}}},
      {"perpendicular",
       {L, L},
       k3,
       {{0, 0, 0, 0.6, 0.8, 0}, {1, 1, 0, 0, 0, 1}},
       {},
       {{0, 0, 0, 0.6, 0.8, 0}, {0, 0, 1, 0, 1, 0}}},
      {"perpendicular",
       {E, E},
       k3,
       {{0.6, 0.8, 0, 1}, {0, 0, 1, 3}},
       {},
       {{0.6, 0.8, 0, 1}, {0.6, 0.8, 0, 3}}},
      {"perpendicular",
       {L, E},
       k3,
       {{0, 0, 1, 0.6, 0.8, 0}, {0.6, 0.8, 0, 1}},
       {1},
       {{0, 0, 1, 0.6, 0.8, 0}, {0, 0.6, 0.8, 1}}}};
  return all;
}

const std::vector<Example>& examples_of_contact() {
  static const std::vector<Example> all = {
      {"tangent", {L, C}, k2, {{0.6, 0.8, 1}, {3, 4, 4}}, {}, {{0.6, 0.8, 1}, {3, 4, 3}}},
      {"tangent", {L, S}, k3, {{3, 4, 0, 0, 0, 1}, {0, 0, 9, 5}}, {}, {{3, 4, 0, 0, 0, 1}, {0, 0, 9, 4}}},
      {"tangent", {E, S}, k3, {{0, 0, 1, 7}, {1, 2, 3, 4}}, {}, {{0, 0, 1, 7}, {1, 2, 3, 3}}},
      {"tangent", {C, C}, k2, {{0, 0, 2}, {3, 4, 3}}, {}, {{0, 0, 2}, {3, 4, 4}}},
      {"tangent", {C, C}, k2, {{0, 0, 2}, {3, 4, 7}}, {}, {{0, 0, 2}, {3, 4, 6}}},
      {"tangent", {C, C}, k2, {{0, 0, 2}, {3, 4, 3}}, {}, {{0, 0, 2}, {3, 4, 7}}, 1},
      {"tangent", {C, C}, k2, {{0, 0, 2}, {3, 4, 7}}, {}, {{0, 0, 2}, {3, 4, 3}}, 2},
      {"tangent", {S, S}, k3, {{0, 0, 0, 2}, {2, 3, 6, 5}}, {}, {{0, 0, 0, 2}, {2, 3, 6, 6}}},
      {"tangent", {S, S}, k3, {{0, 0, 0, 2}, {2, 3, 6, 5}}, {}, {{0, 0, 0, 2}, {2, 3, 6, 9}}, 1},
      {"tangent", {S, S}, k3, {{0, 0, 0, 2}, {2, 3, 6, 9}}, {}, {{0, 0, 0, 2}, {2, 3, 6, 5}}, 2}};
  return all;
}

std::vector<Example> all_examples() {
  std::vector<Example> result;
  for (const auto* examples :
       {&examples_of_points(), &examples_of_incidence(), &examples_of_directions(), &examples_of_contact()})
    result.insert(result.end(), examples->begin(), examples->end());
  return result;
}

const ConstraintKind& kind_of(const Example& example) {
  for (const ConstraintKind* kind : constraint_registry().kinds(example.kind)) {
    if (kind->sorts == example.sorts) return *kind;
  }
  throw InputError(std::string("no such kind: ") + example.kind);
}

double largest_value(const Example& example, const Figure& figure) {
  const GeometricEquations equations =
      geometric_equations(system_of({&kind_of(example), example.universe}, example.interpretation), {});
  std::vector<double> numbers = flat(figure);
  numbers.insert(numbers.end(), example.auxiliaries.begin(), example.auxiliaries.end());
  double result = 0;
  for (const double value : values_at(equations, numbers)) result = std::max(result, std::abs(value));
  return result;
}

TEST(BooleanConstraints, HoldWhereTheySay) {
  for (const Example& example : all_examples()) {
    const std::string name = name_of(ConstraintCase{&kind_of(example), example.universe});
    EXPECT_LT(largest_value(example, example.holds), 1e-14) << name;
    EXPECT_GT(largest_value(example, example.fails), 0.1) << name;
  }
}

TEST(BooleanConstraints, HaveAnExampleEach) {
  const std::vector<Example> examples = all_examples();
  for (const auto& [kind, universe] : all_constraint_cases()) {
    if (kind->is_metric()) continue;
    for (std::size_t i = 0; i < kind->interpretations.size(); ++i) {
      const auto is_of_it = [&, kind = kind, universe = universe](const Example& example) {
        return &kind_of(example) == kind && example.universe == universe && example.interpretation == i;
      };
      EXPECT_TRUE(std::ranges::any_of(examples, is_of_it)) << name_of(ConstraintCase{kind, universe}) << i;
    }
  }
}

}  // namespace
}  // namespace gcslab
