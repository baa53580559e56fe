#include "expression/expression.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "expression/differentiate.h"
#include "expression/parser.h"
#include "expression/printer.h"
#include "expression/tape_evaluator.h"
#include "interval/fast_interval.h"
#include "interval/point_numbers.h"
#include "interval/rational.h"

namespace gcslab {
namespace {

const std::vector<std::string> kVariables = {"x", "y"};

class ExpressionTest : public testing::Test {
 protected:
  Expression parse(const std::string& text) { return parse_expression(graph_, text, kVariables); }
  std::string printed(const std::string& text) { return to_text(parse(text), kVariables); }
  Rational value(const std::string& text, const Rational& x, const Rational& y) {
    const Tape tape(parse(text), 2);
    TapeEvaluator<Rational> evaluator(tape);
    evaluator.evaluate(std::vector<Rational>{x, y});
    return evaluator.value();
  }
  std::string error(const std::string& text) {
    try {
      parse(text);
    } catch (const InputError& problem) {
      return problem.what();
    }
    return "";
  }

  ExpressionGraph graph_;
};

TEST_F(ExpressionTest, EqualSubexpressionsAreOneNode) {
  EXPECT_EQ(parse("(x + y)^2 * (x + y)"), parse("(x+y)^2*(y+x)"));
  EXPECT_EQ(parse("x*y"), parse("y*x"));
  EXPECT_NE(parse("x*x"), parse("x^2"));  // over intervals the two differ
}

TEST_F(ExpressionTest, ConstantsAreExactRationals) {
  EXPECT_EQ(parse("0.1 + 0.2"), parse("3/10"));
  EXPECT_EQ(parse("1e-3"), parse("1/1000"));
  EXPECT_EQ(parse("2^-2"), parse("1/4"));
  EXPECT_EQ(parse("2^3^2"), parse("512"));
  EXPECT_EQ(parse("min(1/3, 0.33)"), parse("0.33"));
}

TEST_F(ExpressionTest, PowerBindsTighterThanMinusAndToTheRight) {
  EXPECT_EQ(parse("-x^2"), parse("-(x^2)"));
  EXPECT_NE(parse("-x^2"), parse("(-x)^2"));
  EXPECT_EQ(parse("x^2^3"), parse("x^8"));
  EXPECT_EQ(parse("x^(1/2)"), parse("sqrt(x)"));
  EXPECT_EQ(value("-x^2 + 2*x*y/4 - -y", 3, 5), Rational(7, 2));  // -9 + 15/2 + 5
}

TEST_F(ExpressionTest, SimplifyingKeepsTheDomain) {
  EXPECT_EQ(parse("0*x"), parse("0"));
  EXPECT_NE(parse("0*log(x)"), parse("0"));
  EXPECT_NE(parse("(1/x)^0"), parse("1"));
  EXPECT_EQ(parse("x + 0"), parse("x"));
  EXPECT_EQ(parse("1*x/1"), parse("x"));
}

TEST_F(ExpressionTest, PrintedTextParsesBackToTheSameNode) {
  for (const char* text :
       {"x - (y - 1)", "x - y - 1",       "-(x + y)",        "(-x)^2",  "-x^2",   "x/(y*x)",
        "x/y/x",       "x*(y/x)",         "(x + y)*(x - y)", "x^(2/3)", "x^(-2)", "3/4*x",
        "x^2*(1/3)",   "sqrt(x^2 + y^2)", "min(x, y + 1)",   "-3 + x",  "x + -3", "exp(-x)*pi",
        "(x/2)^3",     "2^(1/2)",         "x + (y + x)"}) {
    const Expression once = parse(text);
    EXPECT_EQ(parse(to_text(once, kVariables)), once) << text << " was printed as " << printed(text);
  }
  EXPECT_EQ(printed("x^3+y^3-3*x*y"), "x^3 + y^3 - 3*x*y");
}

TEST_F(ExpressionTest, LatexIsReadable) {
  EXPECT_EQ(to_latex(parse("x^10/3 + sqrt(y)"), kVariables), "\\frac{x^{10}}{3} + \\sqrt{y}");
  EXPECT_EQ(to_latex(parse("1/2*x*y"), kVariables), "\\frac{1}{2} x y");
}

TEST_F(ExpressionTest, ErrorsTellColumnAndRemedy) {
  EXPECT_EQ(error("x + * y"), "in \"x + * y\", column 5: expected a number, a variable, a function or '('");
  EXPECT_EQ(error("x + z"), "in \"x + z\", column 5: unknown variable 'z' (did you mean 'x'?)");
  EXPECT_EQ(error("sqt(x)"), "in \"sqt(x)\", column 1: unknown function 'sqt' (did you mean 'sqr'?)");
  EXPECT_NE(error("x^y").find("exponent must be a rational constant"), std::string::npos);
  EXPECT_NE(error("x ** 2").find("a power is written ^"), std::string::npos);
  EXPECT_NE(error("(x").find("expected ')'"), std::string::npos);
  EXPECT_NE(error("1/0").find("division by the constant 0"), std::string::npos);
  EXPECT_NE(error("10^10^10").find("bits"), std::string::npos);
  EXPECT_NE(error("x^(-2147483648)").find("too large"), std::string::npos);  // no int could be lessened by 1
  EXPECT_NE(error("min(x)").find("two arguments"), std::string::npos);
  EXPECT_NE(error("").find("column 1"), std::string::npos);
  EXPECT_NE(error(std::string(100000, '(')).find("nested too deeply"), std::string::npos);
  EXPECT_NE(error("1.2.3").find("column"), std::string::npos);
}

TEST_F(ExpressionTest, EquationsAndInequalitiesTakeOneRelation) {
  EXPECT_EQ(parse_equation(graph_, "x = y", kVariables), parse("x - y"));
  EXPECT_EQ(parse_inequality(graph_, "x >= 1/2", kVariables), parse("1/2 - x"));
  EXPECT_THROW(parse_equation(graph_, "x = y = 1", kVariables), InputError);
  EXPECT_THROW(parse_equation(graph_, "x <= y", kVariables), InputError);
  EXPECT_THROW(parse_inequality(graph_, "x < y", kVariables), InputError);
}

TEST_F(ExpressionTest, SymbolicForwardAndReverseDerivativesAgreeExactly) {
  const std::string text = "(x^3 - 2*x*y)/(x + y^2) + abs(x)*min(x, y)^2";
  for (const char* smooth : {"(x^3 - 2*x*y)/(x + y^2)", "x^5*y^(-2) - sqr(x*y)", "x/y - y/(x*x)"}) {
    const std::vector<Rational> point = {Rational(3, 2), Rational(-5, 7)};
    const Expression f = parse(smooth);
    const Tape tape(f, 2);
    TapeEvaluator<Rational> evaluator(tape);
    evaluator.evaluate(point);
    const std::vector<Rational> reverse(evaluator.reverse_gradient().begin(),
                                        evaluator.reverse_gradient().end());
    const std::vector<Rational> forward(evaluator.forward_gradient().begin(),
                                        evaluator.forward_gradient().end());
    EXPECT_EQ(reverse, forward);
    for (int i = 0; i < 2; ++i) {
      const Tape derivative(differentiate(f, i), 2);
      TapeEvaluator<Rational> symbolic(derivative);
      symbolic.evaluate(point);
      EXPECT_EQ(symbolic.value(), reverse[static_cast<std::size_t>(i)]) << smooth;
    }
  }
  EXPECT_THROW(differentiate(parse(text), 0), NotApplicable);
  EXPECT_TRUE(differentiate(parse("abs(y)*x"), 0) == parse("abs(y)"));
}

TEST_F(ExpressionTest, IntervalGradientsEncloseKinks) {
  const Tape tape(parse("abs(x) + max(x, y)"), 2);
  const UpwardRounding scope;
  TapeEvaluator<FastInterval> evaluator(tape);
  evaluator.evaluate(std::vector<FastInterval>{FastInterval(-1, 2), FastInterval(0, 1)});
  const auto gradient = evaluator.reverse_gradient();
  EXPECT_EQ(gradient[0].interval(), Interval(-1, 2));  // [-1,1] + [0,1]
  EXPECT_EQ(gradient[1].interval(), Interval(0, 1));
}

TEST_F(ExpressionTest, TheDomainIsChecked) {
  const auto defined = [this](const std::string& text, double lower, double upper) {
    const Tape tape(parse(text), 2);
    const UpwardRounding scope;
    TapeEvaluator<FastInterval> evaluator(tape);
    evaluator.evaluate(std::vector<FastInterval>{FastInterval(lower, upper), FastInterval(0, 1)});
    return evaluator.defined_everywhere();
  };
  EXPECT_TRUE(defined("sqrt(x)", 0, 1));
  EXPECT_FALSE(defined("sqrt(x)", -1, 1));
  EXPECT_FALSE(defined("log(x)", 0, 1));
  EXPECT_FALSE(defined("1/x", -1, 1));
  EXPECT_FALSE(defined("tan(x)", 1, 2));
  EXPECT_TRUE(defined("tan(x)", -1, 1));
  EXPECT_FALSE(defined("x^(-1/3)", -1, 1));
  EXPECT_TRUE(defined("x^(5/3)", -1, 1));
  EXPECT_FALSE(defined("asin(x)", 0, 2));
}

}  // namespace
}  // namespace gcslab
