#include "packing/angle_sum.h"

#include <gtest/gtest.h>
#include <numbers>

#include "base/random.h"
#include "interval/mpfr_interval.h"
#include "packing/random_triangulation.h"
#include "support/fuzz.h"
#include "unit/packing/apollonian_network.h"

namespace gcslab {
namespace {

constexpr int kBits = 200;

int degree(const Triangulation& graph, int vertex) {
  int result = 0;
  for (const auto& [u, v] : graph.edges()) result += u == vertex || v == vertex ? 1 : 0;
  return result;
}

std::vector<MpfrInterval> numbers(const std::vector<Rational>& values) {
  std::vector<MpfrInterval> result;
  for (const Rational& value : values) result.push_back(NumberTraits<MpfrInterval>::from_rational(value));
  return result;
}

/// Equal radii: all triangles are equilateral, so that six discs of radius 1 just surround a seventh.
TEST(AngleSum, OfEqualDiscsIsAThirdOfPiAFace) {
  const NumberTraits<MpfrInterval>::Scope scope(kBits);
  const Triangulation graph = random_triangulation({.inner_vertices = 30, .flips = 300, .seed = fuzz_seed()});
  const std::vector<Rational> ones(static_cast<std::size_t>(graph.vertices()), 1);
  const std::vector<MpfrInterval> sums = angle_sums<MpfrInterval>(graph, numbers(ones));
  const MpfrInterval third = NumberTraits<MpfrInterval>::pi() / NumberTraits<MpfrInterval>::from_rational(3);
  bool has_flower = false;
  for (int v = 3; v < graph.vertices(); ++v) {
    const MpfrInterval expected = third * NumberTraits<MpfrInterval>::from_rational(degree(graph, v));
    const Interval difference = (sums[static_cast<std::size_t>(v - 3)] - expected).interval();
    EXPECT_TRUE(contains(difference, 0));
    EXPECT_LT(width(difference), 1e-55);
    has_flower = has_flower || degree(graph, v) == 6;
  }
  EXPECT_TRUE(has_flower);
}

/// Discs of which Descartes' theorem says that they touch.
TEST(AngleSum, OfAnApollonianPackingIsTwoPi) {
  const NumberTraits<MpfrInterval>::Scope scope(kBits);
  const std::uint64_t seed = fuzz_seed();
  for (std::uint64_t i = 0; i < 5; ++i) {
    const ApollonianNetwork network(25, seed + i);
    std::vector<Rational> radii;
    for (const RationalDisc& disc : network.discs) radii.push_back(disc.radius);
    const MpfrInterval full = NumberTraits<MpfrInterval>::from_rational(2) * NumberTraits<MpfrInterval>::pi();
    for (const MpfrInterval& sum : angle_sums<MpfrInterval>(network.graph, numbers(radii))) {
      const Interval excess = (sum - full).interval();
      EXPECT_TRUE(contains(excess, 0));
      EXPECT_LT(width(excess), 1e-50);
    }
  }
}

TEST(AngleSum, DecreasesWithItsOwnRadiusAndIncreasesWithItsNeighbours) {
  const Triangulation graph = random_triangulation({.inner_vertices = 15, .flips = 200, .seed = fuzz_seed()});
  Random random(fuzz_seed(), "angle_sum_test");
  std::vector<double> radii(static_cast<std::size_t>(graph.vertices()));
  for (double& radius : radii) radius = random.uniform(0.1, 3);
  const std::vector<double> before = angle_sums<double>(graph, radii);
  for (int w = 3; w < graph.vertices(); ++w) {
    std::vector<double> larger = radii;
    larger[static_cast<std::size_t>(w)] *= 1.01;
    const std::vector<double> after = angle_sums<double>(graph, larger);
    for (int v = 3; v < graph.vertices(); ++v) {
      const double change = after[static_cast<std::size_t>(v - 3)] - before[static_cast<std::size_t>(v - 3)];
      if (v == w) {
        EXPECT_LT(change, 0);
      } else if (graph.has_edge(v, w)) {
        EXPECT_GT(change, 0);
      } else {
        EXPECT_EQ(change, 0);
      }
    }
  }
}

/// (-J) x = b, against difference quotients along x in the logarithms.
TEST(AngleSumDerivative, IsThatOfDifferenceQuotients) {
  const Triangulation graph = random_triangulation({.inner_vertices = 12, .flips = 200, .seed = fuzz_seed()});
  Random random(fuzz_seed(), "angle_sum_test");
  std::vector<double> radii(static_cast<std::size_t>(graph.vertices()));
  for (double& radius : radii) radius = random.uniform(0.5, 2);
  std::vector<double> right_side(static_cast<std::size_t>(graph.inner_vertices()));
  for (double& entry : right_side) entry = random.uniform(-1, 1);
  const auto x = AngleSumDerivative(graph, radii).solve(right_side);
  ASSERT_TRUE(x);
  constexpr double kStep = 1e-5;
  std::vector<double> above = radii, below = radii;
  for (std::size_t i = 0; i < x->size(); ++i) {
    above[i + 3] *= std::exp(kStep * (*x)[i]);
    below[i + 3] *= std::exp(-kStep * (*x)[i]);
  }
  const std::vector<double> upper = angle_sums<double>(graph, above),
                            lower = angle_sums<double>(graph, below);
  for (std::size_t i = 0; i < x->size(); ++i)
    EXPECT_NEAR(-(upper[i] - lower[i]) / (2 * kStep), right_side[i], 1e-6);
}

TEST(ApproximateRadii, AreThoseOfDescartes) {
  const std::uint64_t seed = fuzz_seed();
  for (std::uint64_t i = 0; i < 10; ++i) {
    const ApollonianNetwork network(30, seed + i);
    const auto radii = approximate_radii(network.graph, {1, 2, 3});
    ASSERT_TRUE(radii);
    for (std::size_t v = 0; v < radii->size(); ++v) {
      const double expected = network.discs[v].radius.get_d();
      EXPECT_NEAR((*radii)[v] / expected, 1, 1e-8);
    }
  }
}

}  // namespace
}  // namespace gcslab
