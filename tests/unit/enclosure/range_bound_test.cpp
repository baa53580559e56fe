// Ranges that are known by hand, most of them printed in Tahari 2011.

#include "enclosure/range_bound.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "enclosure/bound_registry.h"
#include "enclosure/dyadic_slack.h"
#include "expression/parser.h"
#include "polynomial/recognise.h"

namespace gcslab {
namespace {

const std::vector<std::string> kVariables = {"x", "y"};

Interval range_of(const std::string& function, const Box& box, const std::string& bound,
                  const std::map<std::string, std::string>& options = {}) {
  auto graph = std::make_shared<ExpressionGraph>();
  const int variables = static_cast<int>(box.size());
  const Expression f = parse_expression(*graph, function, std::span(kVariables).first(box.size()));
  const BoundVariant& variant = bound_registry().at(bound);
  return variant.make(BoundTarget(graph, f, variables), Options(variant.options, options, bound))->over(box);
}

TEST(NaturalBound, LosesTheDependenceOfVariables) {
  EXPECT_EQ(range_of("x*(1 - x)", {{0, 1}}, "natural"), Interval(0, 1));
  EXPECT_EQ(range_of("x*(1 - x)", {{0, 2}}, "natural"), Interval(-2, 2));
  EXPECT_EQ(range_of("x - x^2", {{0, 1}}, "natural"), Interval(-1, 1));
  EXPECT_EQ(range_of("x*x", {{-2, 3}}, "natural"), Interval(-6, 9));
  EXPECT_EQ(range_of("x^2", {{-2, 3}}, "natural"), Interval(0, 9));
}

TEST(NaturalBound, FormsAreAlternatives) {
  EXPECT_EQ(range_of("x*(1 - x)", {{0, 1}}, "natural", {{"form", "expanded"}}), Interval(-1, 1));
  EXPECT_EQ(range_of("x - x^2", {{0, 1}}, "natural", {{"form", "horner"}}), Interval(0, 1));
  EXPECT_EQ(range_of("x - x^2", {{0, 1}}, "natural", {{"form", "tightest"}}), Interval(0, 1));
  EXPECT_EQ(range_of("exp(x)", {{0, 0}}, "natural", {{"form", "tightest"}}), Interval(1, 1));
  EXPECT_THROW(range_of("exp(x)", {{0, 0}}, "natural", {{"form", "horner"}}), NotApplicable);
}

TEST(CentredBound, MeanValueFormOfTheParabola) {
  for (const char* derivatives : {"reverse", "forward"}) {
    EXPECT_EQ(range_of("x*(1 - x)", {{0, 1}}, "centred", {{"derivatives", derivatives}}),
              Interval(-0.25, 0.75));
  }
}

TEST(CentredBound, TwoCentresAreTighterThanOne) {
  const Box box = {{0, 1}, {1, 3}};
  for (const char* f : {"x^3 - x*y", "x^2*y - y", "exp(x)*y - y^2"}) {
    EXPECT_LE(width(range_of(f, box, "centred", {{"centre", "bicentred"}})),
              width(range_of(f, box, "centred")))
        << f;
  }
}

TEST(CentredSecondOrderBound, IsExactForAParabola) {
  EXPECT_EQ(range_of("x*(1 - x)", {{0, 1}}, "centred_second_order"), Interval(0, 0.25));
  EXPECT_THROW(range_of("abs(x)", {{0, 1}}, "centred_second_order"), NotApplicable);
}

TEST(TaubinBound, ThePlainFormDoesNotKnowThatSquaresArePositive) {
  EXPECT_EQ(range_of("x*(1 - x)", {{0, 1}}, "taubin"), Interval(0, 0.5));
  EXPECT_EQ(range_of("x*(1 - x)", {{0, 1}}, "taubin_even"), Interval(0, 0.25));
}

TEST(BernsteinBound, IsTheHullOfTheCoefficients) {
  EXPECT_EQ(range_of("x*(1 - x)", {{0, 1}}, "bernstein"), Interval(0, 0.5));
  const Interval folium = range_of("x^3 + y^3 - 3*x*y", {{0, 1}, {0, 1}}, "bernstein");  // b_22 = -4/3
  EXPECT_EQ(folium.upper, 1);
  EXPECT_LE(folium.lower, -4.0 / 3);
  EXPECT_NEAR(folium.lower, -4.0 / 3, 1e-15);
}

TEST(AffineBound, KeepsLinearCorrelations) {
  EXPECT_EQ(range_of("x - x", {{0, 1}}, "affine_chebyshev"), Interval(0, 0));
  EXPECT_LE(width(range_of("(10 + x + y)*(10 - x + y)", {{-2, 2}, {-1, 1}}, "affine_chebyshev")), 60);
}

TEST(ExactBound, FindsTheRange) {
  const Interval parabola = range_of("x*(1 - x)", {{0, 2}}, "exact");
  EXPECT_EQ(parabola.lower, -2);
  EXPECT_NEAR(parabola.upper, 0.25, 1e-8);
  EXPECT_GE(parabola.upper, 0.25);
  const Interval saddle = range_of("x*y - x - y", {{-1, 2}, {-1, 2}}, "exact");
  EXPECT_NEAR(saddle.lower, -3, 1e-8);  // (x - 1)(y - 1) - 1
  EXPECT_NEAR(saddle.upper, 3, 1e-8);
}

TEST(DyadicSlack, IsZeroWhereAllCornersAreExact) {
  ExpressionGraph graph;
  const Expression f = parse_expression(graph, "x^2*y", kVariables);
  const Polynomial p = *recognise_polynomial(f, 2).polynomial;
  EXPECT_EQ(dyadic_slack(p, {{-2, 2}, {0, 1}}, 30), 0);
  EXPECT_EQ(dyadic_slack(p, {{0.5, 0.5}, {-1.25, 1.25}}, 40), 0);
  EXPECT_GT(dyadic_slack(p, {{0.1, 0.8}, {0, 1}}, 5), 0);
  EXPECT_LT(dyadic_slack(p, {{0.1, 0.8}, {0, 1}}, 5), Rational(1, 1'000'000'000));
  EXPECT_GT(dyadic_slack(p, {{-2, 2}, {0, 1}}, 60), 0);
}

}  // namespace
}  // namespace gcslab
