#include "linear_program/exact_polytope.h"

#include <algorithm>
#include <gtest/gtest.h>

#include "base/random.h"
#include "support/fuzz.h"

namespace gcslab {
namespace {

using Point = ExactPolytope::Point;

HalfSpace half_space(std::vector<Rational> normal, Rational least) { return {std::move(normal), least}; }

std::vector<HalfSpace> cube(std::size_t dimension) {
  std::vector<HalfSpace> result;
  for (std::size_t i = 0; i < dimension; ++i) {
    Point normal(dimension, 0);
    normal[i] = 1;
    result.push_back({normal, 0});
    normal[i] = -1;
    result.push_back({normal, -1});
  }
  return result;
}

TEST(ExactPolytope, CubesHaveTheirVerticesFacetsAndVolume) {
  std::size_t corners = 1;
  for (std::size_t dimension = 1; dimension <= 4; ++dimension) {
    corners *= 2;
    const ExactPolytope polytope(cube(dimension));
    EXPECT_EQ(polytope.vertices().size(), corners);
    EXPECT_EQ(polytope.facets().size(), 2 * dimension);
    EXPECT_EQ(polytope.volume(), 1);
  }
  EXPECT_EQ(ExactPolytope(cube(2)).edges().size(), 4U);
  EXPECT_EQ(ExactPolytope(cube(3)).edges().size(), 12U);
}

/// Tahari 2011, section 5.1: y - 2x + 1 >= 0, 2x - 2y >= 0, y >= 0.
TEST(ExactPolytope, ABernsteinTriangleHasTheControlPointsOfTheParabola) {
  const ExactPolytope triangle({half_space({-2, 1}, -1), half_space({2, -2}, 0), half_space({0, 1}, 0)});
  EXPECT_EQ(triangle.vertices(), (std::vector<Point>{{0, 0}, {Rational(1, 2), 0}, {1, 1}}));
  EXPECT_EQ(triangle.volume(), Rational(1, 4));
  EXPECT_EQ(triangle.edges().size(), 3U);
}

TEST(ExactPolytope, RedundantHalfSpacesHaveNoFacets) {
  std::vector<HalfSpace> sides = cube(3);
  sides.push_back(half_space({1, 1, 1}, 0));   // touches one vertex
  sides.push_back(half_space({2, 0, 0}, 0));   // the same as x >= 0
  sides.push_back(half_space({1, 1, 0}, -5));  // touches nothing
  const ExactPolytope polytope(sides);
  EXPECT_EQ(polytope.vertices().size(), 8U);
  EXPECT_EQ(polytope.facets().size(), 6U);
  EXPECT_EQ(polytope.volume(), 1);
}

TEST(ExactPolytope, EmptyAndFlatOnesHaveNoVolume) {
  std::vector<HalfSpace> empty = cube(2);
  empty.push_back(half_space({1, 1}, 3));
  EXPECT_TRUE(ExactPolytope(empty).vertices().empty());
  EXPECT_EQ(ExactPolytope(empty).volume(), 0);
  std::vector<HalfSpace> flat = cube(3);
  flat.push_back(half_space({0, 0, 1}, 1));
  EXPECT_EQ(ExactPolytope(flat).vertices().size(), 4U);
  EXPECT_EQ(ExactPolytope(flat).volume(), 0);
}

/// Cut by a plane, a polytope's two parts make up the whole.
TEST(ExactPolytope, PartsAddUpToTheWhole) {
  Random random(fuzz_seed(), "exact polytope");
  for (std::size_t i = 0; i < 60; ++i) {
    const auto dimension = static_cast<std::size_t>(random.integer(2, 4));
    std::vector<HalfSpace> whole = cube(dimension);
    const auto cut = [&] {
      HalfSpace side;
      Rational middle = 0;
      for (std::size_t k = 0; k < dimension; ++k) {
        side.normal.emplace_back(random.integer(-3, 3));
        middle += side.normal.back() / 2;
      }
      side.least = middle - Rational(random.integer(0, 8)) / 8;
      return side;
    };
    whole.push_back(cut());
    HalfSpace side = cut();
    std::vector<HalfSpace> upper = whole, lower = whole;
    upper.push_back(side);
    for (Rational& coefficient : side.normal) coefficient = -coefficient;
    side.least = -side.least;
    lower.push_back(side);
    if (std::ranges::all_of(side.normal, [](const Rational& c) { return c == 0; })) continue;
    EXPECT_EQ(ExactPolytope(upper).volume() + ExactPolytope(lower).volume(), ExactPolytope(whole).volume())
        << "case " << i;
  }
}

}  // namespace
}  // namespace gcslab
