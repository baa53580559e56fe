// Radii and places of Apollonian packings, which Descartes' theorem gives exactly.

#include <gtest/gtest.h>

#include "packing/angle_sum.h"
#include "packing/circle_layout.h"
#include "packing/radii_enclosure.h"
#include "packing/random_triangulation.h"
#include "support/fuzz.h"
#include "unit/packing/apollonian_network.h"

namespace gcslab {
namespace {

constexpr int kBits = 160;

bool holds(const MpfrInterval& x, const Rational& value) {
  return mpfr_cmp_q(x.lower(), value.get_mpq_t()) <= 0 && mpfr_cmp_q(x.upper(), value.get_mpq_t()) >= 0;
}

double relative_width(const MpfrInterval& x) {
  return width((x / x - NumberTraits<MpfrInterval>::from_rational(1)).interval());
}

std::optional<std::vector<MpfrInterval>> enclosed(const Triangulation& graph, int bits) {
  const auto approximate = approximate_radii(graph, {1, 2, 3});
  return approximate ? enclose_radii(graph, {1, 2, 3}, *approximate, bits) : std::nullopt;
}

TEST(RadiiEnclosure, HoldsTheRadiiOfDescartes) {
  const NumberTraits<MpfrInterval>::Scope scope(kBits);
  const std::uint64_t seed = fuzz_seed();
  for (std::uint64_t i = 0; i < 10; ++i) {
    const ApollonianNetwork network(20, seed + i);
    const auto radii = enclosed(network.graph, kBits);
    ASSERT_TRUE(radii);
    for (std::size_t v = 0; v < radii->size(); ++v) {
      EXPECT_TRUE(holds((*radii)[v], network.discs[v].radius)) << "seed " << seed + i << ", vertex " << v;
      EXPECT_LT(relative_width((*radii)[v]), 1e-38);
    }
  }
}

/// More bits, a narrower enclosure inside of the wider one, also of graphs that are no Apollonian network.
TEST(RadiiEnclosure, NarrowsWithThePrecision) {
  const std::uint64_t seed = fuzz_seed();
  for (std::uint64_t i = 0; i < 5; ++i) {
    const Triangulation graph = random_triangulation({.inner_vertices = 25, .flips = 500, .seed = seed + i});
    std::vector<Interval> wide;
    {
      const NumberTraits<MpfrInterval>::Scope scope(64);
      const auto radii = enclosed(graph, 64);
      ASSERT_TRUE(radii);
      for (const MpfrInterval& radius : *radii) wide.push_back(radius.interval());
    }
    const NumberTraits<MpfrInterval>::Scope scope(kBits);
    const auto radii = enclosed(graph, kBits);
    ASSERT_TRUE(radii);
    for (std::size_t v = 0; v < wide.size(); ++v) EXPECT_TRUE(subset((*radii)[v].interval(), wide[v]));
  }
}

/// No enclosure is claimed around points that are far from the radii.
TEST(RadiiEnclosure, IsRefusedWhereTheInequalitiesFail) {
  const NumberTraits<MpfrInterval>::Scope scope(64);
  const ApollonianNetwork network(10, fuzz_seed());
  const std::vector<double> far(13, 1e-30);
  const auto radii = enclose_radii(network.graph, {1, 2, 3}, far, 64);
  if (!radii) return;
  for (std::size_t v = 0; v < radii->size(); ++v) EXPECT_TRUE(holds((*radii)[v], network.discs[v].radius));
}

TEST(CircleLayout, HoldsThePlacesOfDescartes) {
  const NumberTraits<MpfrInterval>::Scope scope(kBits);
  const std::uint64_t seed = fuzz_seed();
  for (std::uint64_t i = 0; i < 10; ++i) {
    const ApollonianNetwork network(30, seed + i);
    const auto radii = enclosed(network.graph, kBits);
    ASSERT_TRUE(radii);
    const std::vector<EnclosedDisc> discs = lay_out(network.graph, standard_outer_discs(), *radii);
    for (std::size_t v = 0; v < discs.size(); ++v) {
      EXPECT_TRUE(holds(discs[v].x, network.discs[v].x)) << "seed " << seed + i << ", vertex " << v;
      EXPECT_TRUE(holds(discs[v].y, network.discs[v].y)) << "seed " << seed + i << ", vertex " << v;
      EXPECT_LT(width(discs[v].x.interval()), 1e-15);
    }
  }
}

/// Every edge, also those by which no disc was placed.
TEST(CircleLayout, MakesAllDiscsOfEdgesTouch) {
  const NumberTraits<MpfrInterval>::Scope scope(kBits);
  const std::uint64_t seed = fuzz_seed();
  for (std::uint64_t i = 0; i < 5; ++i) {
    const Triangulation graph = random_triangulation({.inner_vertices = 40, .flips = 800, .seed = seed + i});
    const auto radii = enclosed(graph, kBits);
    ASSERT_TRUE(radii);
    const std::vector<EnclosedDisc> discs = lay_out(graph, standard_outer_discs(), *radii);
    for (const auto& [u, v] : graph.edges()) {
      const EnclosedDisc &a = discs[static_cast<std::size_t>(u)], &b = discs[static_cast<std::size_t>(v)];
      const Interval excess = (sqr(a.x - b.x) + sqr(a.y - b.y) - sqr(a.radius + b.radius)).interval();
      EXPECT_TRUE(contains(excess, 0)) << u << " " << v;
      EXPECT_LT(width(excess), 1e-20);
    }
  }
}

}  // namespace
}  // namespace gcslab
