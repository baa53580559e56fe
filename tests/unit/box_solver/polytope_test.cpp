// Every solution in a box stands for a feasible point of its polytope, whichever products are rows.

#include "box_solver/polytope.h"

#include <cmath>
#include <gtest/gtest.h>

#include "base/error.h"
#include "base/random.h"
#include "box_solver/contractor_registry.h"
#include "support/fuzz.h"
#include "unit/verifier/solved_system.h"

namespace gcslab {
namespace {

const BoundProducts kAll[] = {BoundProducts::pairs, BoundProducts::factors, BoundProducts::both};

/// The value of a monomial at z.
Rational value_of(const ScaledMonomial& monomial, const std::vector<Rational>& z) {
  Rational value = 1;
  for (const auto& [variable, power] : monomial.factors) {
    for (int k = 0; k < power; ++k) value *= z[variable];
  }
  return value;
}

int count_rows(const std::string& equation, const Box& box, BoundProducts products) {
  const SystemFunctions functions(system_of({"x", "y"}, {equation, "x - y"}, box));
  const NumberTraits<FastInterval>::Scope scope;
  const ExpansionPlan plan(functions);
  return static_cast<int>(BernsteinPolytope(plan, products).products().size());
}

TEST(BernsteinPolytope, HoldsEveryPointOfTheBoxAtWhichTheFunctionsHold) {
  // The functions vanish everywhere on x = t, y = t^2, and the inequality holds there.
  const Box box = {{-0.5, 0.75}, {-1, 1}};
  const SystemFunctions functions(
      system_of({"x", "y"}, {"x^2 - y", "x^3 - x*y", "x^4*y - y^3"}, box, {"x^3*y <= 1"}));
  const NumberTraits<FastInterval>::Scope scope;
  for (const ExpandedFunctions which : {ExpandedFunctions::equations, ExpandedFunctions::constraints}) {
    const ExpansionPlan plan(functions, which);
    Expansion<FastInterval> expansion(plan);
    expansion.expand(box);
    for (const BoundProducts products : kAll) {
      BernsteinPolytope polytope(plan, products);
      polytope.refill(expansion);
      const LpModel& model = polytope.model();
      Random random(fuzz_seed(), "polytope");
      for (std::size_t i = 0; i < fuzz_cases(200); ++i) {
        const Rational t = rational_from_double(random.uniform(-0.5, 0.75));
        const std::vector<Rational> x = {t, t * t};
        std::vector<Rational> z;
        for (std::size_t v = 0; v < 2; ++v) {
          z.push_back((x[v] - rational_from_double(expansion.midpoints()[v])) /
                      rational_from_double(expansion.radii()[v]));
        }
        for (int row = 0; row < model.rows(); ++row) {
          Rational sum = 0;
          for (std::size_t entry = 0; entry < model.row_columns(row).size(); ++entry) {
            const auto column = static_cast<std::size_t>(model.row_columns(row)[entry]);
            sum +=
                rational_from_double(model.row_midpoints(row)[entry]) * value_of(plan.columns()[column], z);
          }
          const Interval sides = model.sides(row);
          ASSERT_TRUE(std::isinf(sides.lower) || sum >= rational_from_double(sides.lower)) << "row " << row;
          ASSERT_TRUE(std::isinf(sides.upper) || sum <= rational_from_double(sides.upper)) << "row " << row;
        }
      }
    }
  }
}

TEST(BernsteinPolytope, HasTheProductsThatAreAskedFor) {
  const Box box = {{1, 2}, {1, 2}};
  // Columns x, y, x^2, x^3: (1 +- x)^2; with x^3 the pairs (1 +- x)(1 +- x^2), or four products of three.
  EXPECT_EQ(count_rows("x^3 - y", box, BoundProducts::pairs), 2 + 4);
  EXPECT_EQ(count_rows("x^3 - y", box, BoundProducts::factors), 2 + 4);
  EXPECT_EQ(count_rows("x^3 - y", box, BoundProducts::both), 2 + 4 + 4);
  // Of x y: four products, of no higher degree.
  EXPECT_EQ(count_rows("x*y - 2", box, BoundProducts::factors), 4);
}

TEST(BernsteinPolytope, OfBoundFactorsIsTheBernsteinSimplexOfACubic) {
  // Its Bernstein coefficients on [1, 2] are 0.01, 0.26, 0.01 and 0.26: it has no zero there.
  const EquationSystem system =
      system_of({"x"}, {"(x - 1)^3 - 3/2*(x - 1)^2 + 3/4*(x - 1) + 1/100"}, {{1, 2}});
  const SystemFunctions functions(system);
  const auto may_have_roots = [&](const char* products) {
    ContractorSettings settings;
    settings.lp_products = products;
    Box box = system.box;
    ProofTrace trace;
    return make_contractor("lp_reduction", functions, settings)->contract(box, trace);
  };
  EXPECT_FALSE(may_have_roots("factors"));
  EXPECT_FALSE(may_have_roots("both"));
}

TEST(BernsteinPolytope, RefusesAnUnknownWordForProducts) {
  EXPECT_THROW(static_cast<void>(bound_products_from_name("triples")), InputError);
}

}  // namespace
}  // namespace gcslab
