#include "polynomial/recognise.h"

#include <gtest/gtest.h>

#include "expression/parser.h"
#include "expression/printer.h"
#include "polynomial/horner.h"
#include "support/random_polynomial.h"

namespace gcslab {
namespace {

const std::vector<std::string> kNames{"x", "y", "z"};

Recognition recognise(const std::string& text, const RecognitionLimits& limits = {}) {
  ExpressionGraph graph;
  return recognise_polynomial(parse_expression(graph, text, kNames), 3, limits);
}

Polynomial polynomial(const std::string& text) {
  const Recognition result = recognise(text);
  EXPECT_EQ(result.reason, "") << text;
  return result.polynomial.value_or(Polynomial(3));
}

TEST(Recognise, ExpandsExactly) {
  EXPECT_EQ(polynomial("(x + y)^2 - x^2 - y^2").terms(), (Polynomial::Terms{{{1, 1, 0}, 2}}));
  EXPECT_EQ(polynomial("0.1*x - x/10").terms(), Polynomial::Terms{});
  EXPECT_EQ(polynomial("sqr(x - 1/3)").coefficient({0, 0, 0}), Rational(1, 9));
  EXPECT_EQ(polynomial("-(x*y)^3/2").coefficient({3, 3, 0}), Rational(-1, 2));
  EXPECT_EQ(polynomial("z^0*7"), Polynomial::constant(3, 7));
  EXPECT_EQ(polynomial("x/(y - y + 2)").coefficient({1, 0, 0}), Rational(1, 2));
}

TEST(Recognise, NamesTheOperationThatIsNotPolynomial) {
  EXPECT_EQ(recognise("x + sin(y)").reason, "contains sin");
  EXPECT_EQ(recognise("1/x").reason, "divides by a variable");
  EXPECT_EQ(recognise("x/(y - y)").reason, "divides by zero");
  EXPECT_EQ(recognise("pi*x").reason, "contains pi");
  EXPECT_EQ(recognise("x^(2/3)").reason, "contains a power with a fractional exponent");
  EXPECT_EQ(recognise("(x + y)^-2").reason, "contains a negative power");
  EXPECT_EQ(recognise("abs(x)").reason, "contains abs");
  EXPECT_EQ(recognise("max(x, y)").reason, "contains max");
  EXPECT_FALSE(recognise("sqrt(x)").polynomial);
}

TEST(Recognise, RefusesWhatExplodes) {
  EXPECT_NE(recognise("(x + y + z + 1)^200").reason.find("expands beyond"), std::string::npos);
  EXPECT_NE(recognise("(x + y)^30", {.terms = 30}).reason.find("expands beyond 30 terms"), std::string::npos);
  EXPECT_EQ(polynomial("(x + y)^30").terms().size(), 31U);
  EXPECT_NE(recognise("x^1000000").reason.find("degree above"), std::string::npos);
  EXPECT_NE(recognise("((3*x)^9999 * 3)^9999").reason.find("degree above"), std::string::npos);
  EXPECT_NE(recognise("((x - x + 3)^60000)^60000").reason.find("bits"), std::string::npos);
  EXPECT_EQ(polynomial("x^99999").total_degree(), 99999);
}

TEST(Recognise, UndoesToExpressionAndHorner) {
  Random random(1, "horner");
  for (int i = 0; i < 200; ++i) {
    ExpressionGraph graph;
    const Polynomial p = random_polynomial(random, 3, 6, static_cast<int>(random.integer(0, 15)));
    EXPECT_EQ(recognise_polynomial(p.to_expression(graph), 3).polynomial, p);
    EXPECT_EQ(recognise_polynomial(horner_form(p, graph), 3).polynomial, p);
  }
}

std::string horner(const std::string& text) {
  ExpressionGraph graph;
  return to_text(horner_form(polynomial(text), graph), kNames);
}

TEST(Horner, FactorsTheMostFrequentVariable) {
  EXPECT_EQ(horner("x^3 + 2*x^2 + 3*x + 4"), "x*(x*(x + 2) + 3) + 4");
  EXPECT_EQ(horner("x*y + x*z + x"), "x*(y + z + 1)");
  EXPECT_EQ(horner("x*y*z^2 + x*y*z"), "x*y*z*(z + 1)");
}

TEST(Horner, KeepsEvenPowers) {
  const std::string form = horner("x^4 + 2*x^2 + 1");
  EXPECT_TRUE(form == "sqr(x)*(sqr(x) + 2) + 1" || form == "x^2*(x^2 + 2) + 1") << form;
}

TEST(Horner, WritesConstants) {
  EXPECT_EQ(horner("0*x"), "0");
  EXPECT_EQ(horner("5"), "5");
}

}  // namespace
}  // namespace gcslab
