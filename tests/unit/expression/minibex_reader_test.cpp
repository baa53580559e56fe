#include "expression/minibex_reader.h"

#include <gtest/gtest.h>

#include "expression/parser.h"
#include "expression/printer.h"
#include "interval/elementary.h"
#include "support/error_text.h"

namespace gcslab {
namespace {

using Texts = std::vector<std::string>;

EquationSystem read(const std::string& text) { return read_minibex(text, "a.bch"); }
std::string error(const std::string& text) {
  return error_text([&] { read(text); });
}
Texts texts(const std::vector<Expression>& expressions, const EquationSystem& system) {
  Texts result;
  for (const Expression& expression : expressions) result.push_back(to_text(expression, system.variables));
  return result;
}
/// The equations of a system in scalars x, y and a vector v of three.
Texts equations(const std::string& constraints) {
  const EquationSystem system = read("Variables x, y, v[3]; Constraints " + constraints + " end");
  return texts(system.equations, system);
}
std::string constraint_error(const std::string& constraints) {
  return error("Variables x, y, v[3]; Constraints " + constraints + " end");
}
Box domains(const std::string& declarations) { return read(declarations + " Constraints 0 = 0; end").box; }

TEST(MinibexReader, ReadsConstantsVariablesAndConstraints) {
  const EquationSystem system = read(
      "// a comment\n"
      "Constants\n  a = 1.4;\n  n = 2;\n"
      "Variables\n  x[n] in [-2, 2],\n  y in [-0.5, 1e-1];\n"
      "Constraints\n"
      "  /* two\n     equations */\n"
      "  x(1) = y + 1 - a*x(2)^2;\n"
      "  x(2)*y = 0.3;   // and an inequality\n"
      "  x(1) <= x(2);\n  y >= -1/4;\n"
      "end\n");
  EXPECT_EQ(system.variables, (Texts{"x_1", "x_2", "y"}));
  EXPECT_EQ(texts(system.equations, system), (Texts{"x_1 - (y + 1 - 7/5*x_2^2)", "x_2*y - 3/10"}));
  EXPECT_EQ(texts(system.inequalities, system), (Texts{"x_1 - x_2", "-1/4 - y"}));
  EXPECT_EQ(system.box[0], Interval(-2, 2));
  EXPECT_EQ(system.box[2].lower, -0.5);
}

TEST(MinibexReader, DomainsAreRoundedOutwardOnce) {
  const Box box = domains(
      "Variables a in [0.1, 0.1]; b in [1/3, pi]; c in [-10^8, 2*10^9]; d in [0, #3fb999999999999a];");
  EXPECT_EQ(box[0], elementary::enclosing(Rational(1, 10)));
  EXPECT_LT(box[0].lower, box[0].upper);
  EXPECT_EQ(box[1], Interval(elementary::enclosing(Rational(1, 3)).lower, elementary::pi().upper));
  EXPECT_EQ(box[2], Interval(-1e8, 2e9));
  EXPECT_EQ(box[3], Interval(0, 0.1));  // the double 0.1, not the number
}

TEST(MinibexReader, DomainsMayBeUnboundedSharedOrOneAnEntry) {
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(domains("Variables a; b in [-oo, oo]; c in [0, +oo]; d in [-infinity, 1];"),
            (Box{Interval::entire(), Interval::entire(), Interval(0, infinity), Interval(-infinity, 1)}));
  EXPECT_EQ(domains("Variables v[2][2] in [0, 1];"), Box(4, Interval(0, 1)));
  EXPECT_EQ(domains("Variables v[2] in ([0, 1]; [0, 2]); w[1][2] in (3, 4);"),
            (Box{Interval(0, 1), Interval(0, 2), Interval(3), Interval(4)}));
  EXPECT_EQ(domains("Constants wide in [0, 1]; c[2] = (5; 6); Variables a in wide; b[2] in c; d[3] in wide;"),
            (Box{Interval(0, 1), Interval(5), Interval(6), Interval(0, 1), Interval(0, 1), Interval(0, 1)}));
  EXPECT_EQ(domains("Variables m[2][3] in ((0, 1, 2); (3, 4, 5));")[3], Interval(3));
  EXPECT_EQ(domains("Variables x, y in [0, 1];")[0], Interval::entire());  // as IBEX reads it
}

TEST(MinibexReader, ParenthesesCountFromOneAndBracketsFromZero) {
  EXPECT_EQ(equations("v(1) + v[1] = v(3);"), (Texts{"v_1 + v_2 - v_3"}));
  EXPECT_NE(constraint_error("v[3] = 0;").find("x[i] counts from 0, write x(i)"), std::string::npos);
  EXPECT_NE(constraint_error("v(0) = 0;").find("outside 1 .. 3"), std::string::npos);
  const EquationSystem system =
      read("Variables q[1..2], r[0..1][2]; Constraints q[1] + q(2) = r(0,1)*r(1)(2); end");
  EXPECT_EQ(system.variables, (Texts{"q_1", "q_2", "r_0_1", "r_0_2", "r_1_1", "r_1_2"}));
  EXPECT_EQ(texts(system.equations, system), (Texts{"q_1 + q_2 - r_0_1*r_1_2"}));
}

TEST(MinibexReader, IndicesAreIntegerExpressions) {
  EXPECT_EQ(equations("for i=1:2; v(i+1) = v(2*i-1)*i; end"), (Texts{"v_2 - v_1", "v_3 - v_3*2"}));
  EXPECT_NE(constraint_error("v(x) = 0;").find("integer constant as an index of v"), std::string::npos);
  EXPECT_NE(constraint_error("v(1/2) = 0;").find("integer constant"), std::string::npos);
  EXPECT_NE(constraint_error("v = 0;").find("one of its entries"), std::string::npos);
  EXPECT_NE(constraint_error("x(1) = 0;").find("no array"), std::string::npos);
  EXPECT_NE(constraint_error("v(1,1) = 0;").find("2 indices where 1 were expected"), std::string::npos);
  EXPECT_NE(constraint_error("v(1:2) = 0;").find("after the index"), std::string::npos);
}

TEST(MinibexReader, LoopsAndSumsAreWrittenOut) {
  EXPECT_EQ(equations("for i=2:3; v(i) = x^i; end; y = 0;"), (Texts{"v_2 - x^2", "v_3 - x^3", "y"}));
  EXPECT_EQ(equations("for i=1:2; for j=i:2; x = i*10 + j; end; end"), (Texts{"x - 11", "x - 12", "x - 22"}));
  EXPECT_EQ(equations("for i=2:1; for j=1:2; nonsense end; end; x = 0;"), (Texts{"x"}));
  EXPECT_EQ(equations("sum(i=1:3, v(i)^2) = 1;"), (Texts{"v_1^2 + v_2^2 + v_3^2 - 1"}));
  EXPECT_EQ(equations("sum(i=1:2, sum(j=1:i, v(i)*j)) = 0;"), (Texts{"v_1 + (v_2 + v_2*2)"}));
  EXPECT_NE(constraint_error("sum(i=2:1, x) = 0;").find("no term"), std::string::npos);
}

TEST(MinibexReader, AbbreviationsMustBeUsed) {
  EXPECT_EQ(equations("t = x^2; t = t*y; for i=1:2; u = i; v(i) = u; end"),
            (Texts{"x^2 - x^2*y", "v_1 - 1", "v_2 - 2"}));
  EXPECT_EQ(constraint_error("x = 0;\n z = y;"), "a.bch:2: 'z' is no variable and is not used afterwards");
}

TEST(MinibexReader, FunctionsAreExpanded) {
  const std::string functions =
      "Constants c = 3;\n"
      "Function square(u) return u^2; end\n"
      "Function norm(w[2], k)\n s = square(w(1)) + square(w(2)); t = c*s;\n return t^k - sqr(k)\nend\n";
  const EquationSystem system =
      read(functions + "Variables p[2], x; Constraints norm(p, 2) = square(x + 1); end");
  EXPECT_EQ(texts(system.equations, system), (Texts{"(3*(p_1^2 + p_2^2))^2 - 4 - (x + 1)^2"}));
  EXPECT_EQ(error(functions + "Variables p[3]; Constraints norm(p, 2) = 0; end"),
            "a.bch:7: expected the name of an array as large as the parameter w, not 'p'");
  // A function does not see the variables; the error is where the function is wrong.
  EXPECT_EQ(error("Function f(u)\n return u + x; end Variables x; Constraints f(x) = 0; end"),
            "a.bch:2: unknown name 'x' (did you mean 'u'?)");
  EXPECT_NE(error("Function f(u) return f(u); end Variables x; Constraints f(x) = 0; end")
                .find("nested too deeply"),
            std::string::npos);
}

TEST(MinibexReader, ExpressionsMeanWhatIbexMeans) {
  EXPECT_EQ(equations("-x^2 + y = 0;"), (Texts{"-x^2 + y"}));
  EXPECT_EQ(equations("ln(x) + log(y) + sqr(x) + sqrt(y) = exp(x)*pi;"),
            (Texts{"log(x) + log(y) + x^2 + sqrt(y) - exp(x)*pi"}));
  EXPECT_EQ(equations("min(x, y, 1) = max(x, y);"), (Texts{"min(min(x, y), 1) - max(x, y)"}));
  EXPECT_EQ(equations("x^(-2) + x^2.0 + x^(1/2) = 0;"), (Texts{"x^(-2) + x^2 + sqrt(x)"}));
  // The real cube root is defined for negative numbers, the power of IBEX is not.
  EXPECT_EQ(equations("x^(1/3) + abs(x)^(2/3) = 0;"), (Texts{"sqrt(x)^(2/3) + abs(x)^(2/3)"}));
  EXPECT_EQ(equations("x*-y = +2;"), (Texts{"x*(-y) - 2"}));
}

TEST(MinibexReader, AConstraintMayAskForARange) {
  const EquationSystem system =
      read("Variables x, y; Constraints x*y in [1, 2]; x in [-oo, 3]; x + y in [4, 4]; y in [0.5, oo]; end");
  EXPECT_EQ(texts(system.equations, system), (Texts{"x + y - 4"}));
  EXPECT_EQ(texts(system.inequalities, system), (Texts{"1 - x*y", "x*y - 2", "x - 3", "1/2 - y"}));
}

TEST(MinibexReader, RangesHaveConstantEnds) {
  EXPECT_EQ(equations("for i=1:2; v(i) in [i, i]; end"), (Texts{"v_1 - 1", "v_2 - 2"}));
  EXPECT_NE(constraint_error("x in [0, y];").find("expected constant ends"), std::string::npos);
  EXPECT_NE(constraint_error("x in y + 1;").find("expected constant ends"), std::string::npos);
  EXPECT_NE(constraint_error("x in [2, 1];").find("greater"), std::string::npos);
}

TEST(MinibexReader, CoefficientsAreNumbers) {
  const std::string constants = "Constants wide in [0, 1]; point in [2, 2.0]; Variables x; Constraints ";
  EXPECT_EQ(error(constants + "wide*x = 0; end"),
            "a.bch:1: 'wide' is an interval; expected a number, since coefficients must be exact");
  EXPECT_NE(error(constants + "[1, 2]*x = 0; end").find("coefficients must be exact"), std::string::npos);
  const EquationSystem system = read(constants + "point*x + [1, 1] = 0; end");
  EXPECT_EQ(texts(system.equations, system), (Texts{"2*x + 1"}));
}

TEST(MinibexReader, NamesThatOurLanguageForbidsGetUnderscores) {
  EXPECT_EQ(read("Variables x[2], x_1, log, cbrt; Constraints x_1 = x(1)*log + cbrt; end").variables,
            (Texts{"x_1_", "x_2", "x_1", "log_", "cbrt_"}));
}

TEST(MinibexReader, WhatIsNoSystemIsRefused) {
  EXPECT_EQ(error("Variables x in [0,1];\nMinimize x;\nConstraints x = 0; end"),
            "a.bch:2: minimizes, but gcslab solves systems; expected constraints only");
  EXPECT_NE(constraint_error("x < 1;").find("expected '<=', '>=' or '='"), std::string::npos);
  EXPECT_NE(constraint_error("x > 1;").find("strict"), std::string::npos);
  EXPECT_NE(constraint_error("x >= 1;").find("no equation"), std::string::npos);
  EXPECT_NE(constraint_error("atan2(x, y) = 1;").find("not supported"), std::string::npos);
  EXPECT_NE(constraint_error("v' = 1;").find("transposition"), std::string::npos);
  EXPECT_NE(constraint_error("(x; y) = 1;").find("vectors"), std::string::npos);
  EXPECT_NE(constraint_error("x^y = 1;").find("exp(y*ln(x))"), std::string::npos);
  EXPECT_NE(constraint_error("x^-2 = 1;").find("parentheses"), std::string::npos);
  EXPECT_NE(constraint_error("x^2^3 = 1;").find("(x^2)^3"), std::string::npos);
  EXPECT_NE(constraint_error("x/-y = 1;").find("parentheses"), std::string::npos);
}

TEST(MinibexReader, MistakesNameTheLineAndWhatWasExpected) {
  EXPECT_EQ(
      error(""),
      "a.bch:1: expected 'Constants', 'Variables', 'Function' or 'Constraints', not the end of the file");
  EXPECT_EQ(error("Constraints x = 0; end"), "a.bch:1: expected 'Variables' before the constraints, not 'x'");
  EXPECT_EQ(error("Variables\n x in [1, 0]; Constraints x = 0; end"),
            "a.bch:2: the lower end of the interval is greater than the upper end");
  EXPECT_NE(error("Variables x in [1, 0.99999999999999999999]; Constraints x = 0; end").find("greater"),
            std::string::npos);
  EXPECT_NE(error("Variables x in [ln(-1), 2]; Constraints x = 0; end").find("not defined"),
            std::string::npos);
  EXPECT_NE(error("Variables x in [oo, 1]; Constraints x = 0; end").find("-oo as the lower end"),
            std::string::npos);
  EXPECT_EQ(error("Variables x; x; Constraints x = 0; end"),
            "a.bch:1: 'x' is defined twice; expected a new name");
  EXPECT_EQ(error("Variables sin; Constraints x = 0; end"),
            "a.bch:1: expected the name of a variable, not 'sin'");
  EXPECT_EQ(error("Variables x\nConstraints\n x = 0;\n x = 1\n x = 2; end"),
            "a.bch:5: expected ';' after the constraint, not 'x'");
  EXPECT_EQ(constraint_error("x = 0; } "), "a.bch:1: expected a number, a name or '(', not '}'");
  EXPECT_NE(constraint_error("xy = 0;").find("not used"), std::string::npos);
  EXPECT_NE(constraint_error("0 = xy;").find("unknown name 'xy'"), std::string::npos);
  EXPECT_NE(constraint_error("x = 0; end garbage").find("nothing after the last 'end'"), std::string::npos);
  EXPECT_NE(constraint_error("x = 1/0;").find("division by the constant 0"), std::string::npos);
  EXPECT_NE(constraint_error("/* x = 0;").find("expected '*/'"), std::string::npos);
  EXPECT_NE(
      error("Constants c[2] = (1; 2; 3); Variables x; Constraints x = 0; end").find("after the 2 entries"),
      std::string::npos);
  EXPECT_NE(error("Constants c[2] = (1); d[2] = c; e[3] = c; Variables x; Constraints x = 0; end")
                .find("as many entries"),
            std::string::npos);
  EXPECT_NE(error("Variables x in [0, #7ff0000000000000]; Constraints x = 0; end").find("bits of a double"),
            std::string::npos);
}

TEST(MinibexReader, HostileInputIsRefusedAndNotFollowed) {
  EXPECT_NE(constraint_error(std::string(100'000, '(')).find("nested too deeply"), std::string::npos);
  EXPECT_NE(error("Variables x in " + std::string(100'000, '[')).find("nested too deeply"),
            std::string::npos);
  std::string loops;
  for (int i = 0; i < 1000; ++i) loops += "for i" + std::to_string(i) + "=1:1;";
  EXPECT_NE(constraint_error(loops).find("nested too deeply"), std::string::npos);
  EXPECT_NE(constraint_error("for i=1:1e9; x = i; end").find("at most 1000000"), std::string::npos);
  EXPECT_NE(constraint_error("for i=1:1e6; for j=1:1e6; end; end").find("steps"), std::string::npos);
  EXPECT_NE(error("Variables x[1e9]; Constraints x(1) = 0; end").find("100000 entries"), std::string::npos);
  EXPECT_NE(error("Variables x[1000][1000]; Constraints x(1) = 0; end").find("100000 entries"),
            std::string::npos);
  EXPECT_NE(error("Variables a[90000], b[90000]; Constraints a(1) = 0; end").find("100000 variables"),
            std::string::npos);
  EXPECT_NE(error("Variables x[-3]; Constraints x(1) = 0; end").find("size of at least 1"),
            std::string::npos);
  EXPECT_NE(constraint_error("x^1e9 = 0;").find("too large"), std::string::npos);
  EXPECT_NE(constraint_error("x = 2^(10^9);").find("bits"), std::string::npos);
  EXPECT_NE(constraint_error("x = 1e9999*1e9999*1e9999;").find("bits"), std::string::npos);
  EXPECT_NE(error(std::string("Variables x;\0", 13)).find("\\x00"), std::string::npos);
  EXPECT_NE(constraint_error("for i=1:1e6; for j=2:1; x = 1; x = 2; end; end").find("steps"),
            std::string::npos);
  // Each function calls the one before twice: 2^60 calls.
  std::string functions = "Function f0(u) return u; end\n";
  for (int i = 1; i <= 60; ++i) {
    const std::string before = "f" + std::to_string(i - 1);
    functions +=
        "Function f" + std::to_string(i) + "(u) return " + before + "(2*u) + " + before + "(3*u); end\n";
  }
  EXPECT_NE(error(functions + "Variables x; Constraints f60(x) = 0; end").find("steps"), std::string::npos);
}

}  // namespace
}  // namespace gcslab
