// The polytopes of Tahari 2011, section 5.1, from the solver's own rows.

#include "box_solver/monomial_polytope.h"

#include <gtest/gtest.h>

#include "support/fuzz.h"
#include "support/planted_system.h"

namespace gcslab {
namespace {

using Point = ExactPolytope::Point;
using planted::system_of;

struct Lifted {
  Lifted(const std::vector<std::string>& variables, const std::string& equation, const Box& box,
         PolytopeParts parts)
      : functions(system_of(variables, {equation})), plan(functions), bernstein(plan) {
    const NumberTraits<FastInterval>::Scope scope;
    Expansion<FastInterval> expansion(plan);
    expansion.expand(box);
    bernstein.refill(expansion);
    polytope = monomial_polytope(bernstein, expansion, parts);
  }

  SystemFunctions functions;
  ExpansionPlan plan;
  BernsteinPolytope bernstein;
  MonomialPolytope polytope;
};

TEST(MonomialPolytope, OfAParabolaIsTheTriangleOfItsControlPoints) {
  const Lifted lifted({"x"}, "4*x^2 + x - 3", {{0, 1}}, PolytopeParts::products);
  EXPECT_EQ(lifted.polytope.monomials, (std::vector<Exponents>{{1}, {2}}));
  const ExactPolytope polytope(lifted.polytope.half_spaces);
  EXPECT_EQ(polytope.vertices(), (std::vector<Point>{{0, 0}, {Rational(1, 2), 0}, {1, 1}}));
  EXPECT_EQ(ExactPolytope(bernstein_simplex(0, 1, 2).half_spaces).vertices(), polytope.vertices());
}

TEST(MonomialPolytope, TheSquareAboutTheMidpointCutsItsCorner) {
  const Lifted lifted({"x"}, "4*x^2 + x - 3", {{0, 1}}, PolytopeParts::published);
  EXPECT_EQ(ExactPolytope(lifted.polytope.half_spaces).vertices(),
            (std::vector<Point>{{0, 0}, {Rational(1, 4), 0}, {Rational(3, 4), Rational(1, 2)}, {1, 1}}));
}

TEST(MonomialPolytope, OfAProductIsATetrahedron) {
  const Lifted lifted({"x", "y"}, "x*y", {{0, 1}, {0, 1}}, PolytopeParts::all);
  const ExactPolytope polytope(lifted.polytope.half_spaces);
  EXPECT_EQ(polytope.vertices(), (std::vector<Point>{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 1}}));
  EXPECT_EQ(polytope.volume(), Rational(1, 6));
}

/// Tahari 2011, figure 5.3.
TEST(BernsteinSimplex, OfDegreeThreeIsThePublishedTetrahedron) {
  const ExactPolytope polytope(bernstein_simplex(0, 1, 3).half_spaces);
  EXPECT_EQ(polytope.vertices(),
            (std::vector<Point>{
                {0, 0, 0}, {Rational(1, 3), 0, 0}, {Rational(2, 3), Rational(1, 3), 0}, {1, 1, 1}}));
  EXPECT_EQ(polytope.volume(), Rational(1, 54));
}

/// Tahari 2011, section 5.1: "about 0.007" for two unknowns with all their quadratic monomials.
TEST(MonomialPolytope, OfTwoUnknownsHasThePublishedVolume) {
  const Box square = {{0, 1}, {0, 1}};
  const Lifted published({"x", "y"}, "x^2 + x*y + y^2", square, PolytopeParts::published);
  EXPECT_EQ(published.polytope.half_spaces.size(), 13U);
  const Rational volume = ExactPolytope(published.polytope.half_spaces).volume();
  EXPECT_NEAR(volume.get_d(), 0.007, 0.0005);
  const Lifted all({"x", "y"}, "x^2 + x*y + y^2", square, PolytopeParts::all);
  EXPECT_LT(ExactPolytope(all.polytope.half_spaces).volume(), volume);
}

/// The lifted points of the box lie in it, on any box and with any of its parts.
TEST(MonomialPolytope, HoldsEveryPointOfTheBox) {
  Random random(fuzz_seed(), "monomial polytope");
  for (int i = 0; i < 40; ++i) {
    Box box;
    for (int k = 0; k < 2; ++k) {
      const double lower = random.uniform(-2, 2);
      box.emplace_back(lower, lower + random.uniform(0.1, 2));
    }
    const Lifted lifted({"x", "y"}, "x^3 - x*y + y^2", box, PolytopeParts::all);
    for (int sample = 0; sample < 20; ++sample) {
      Point unknowns, point;
      for (const Interval& side : box)
        unknowns.push_back(Rational(side.lower) + (Rational(side.upper) - Rational(side.lower)) *
                                                      Rational(random.integer(0, 16)) / 16);
      for (const Exponents& monomial : lifted.polytope.monomials) {
        Polynomial term(2);
        term.add_term(monomial, 1);
        point.push_back(term.evaluate(unknowns));
      }
      for (const HalfSpace& side : lifted.polytope.half_spaces) ASSERT_TRUE(side.contains(point));
    }
  }
}

}  // namespace
}  // namespace gcslab
