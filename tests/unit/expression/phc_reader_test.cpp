#include "expression/phc_reader.h"

#include <gtest/gtest.h>

#include "expression/printer.h"
#include "support/error_text.h"

namespace gcslab {
namespace {

EquationSystem read(const std::string& text) { return read_phc(text, "a.phc"); }
std::string error(const std::string& text) {
  return error_text([&] { read(text); });
}
std::vector<std::string> equations(const EquationSystem& system) {
  std::vector<std::string> result;
  for (const Expression& equation : system.equations) result.push_back(to_text(equation, system.variables));
  return result;
}
using Texts = std::vector<std::string>;

TEST(PhcReader, ReadsPolynomialsInBothPowerNotations) {
  const EquationSystem system = read("2 3\n x**2*y + 1/2*z*y^2;\n (x - 2.5E-1)*(y + .5)^3 - 1E1*z;\n");
  EXPECT_EQ(equations(system), (Texts{"x^2*y + 1/2*z*y^2", "(x - 1/4)*(y + 1/2)^3 - 10*z"}));
  EXPECT_EQ(system.variables, (Texts{"x", "y", "z"}));
}

TEST(PhcReader, ReadsTheExamplesOfTheManual) {
  const EquationSystem square = read("2\n x**108 + 1.1*y**54 - 1.1*y;\n y**108 + 1.1*x**54 - 1.1*x;\n");
  EXPECT_EQ(equations(square), (Texts{"x^108 + 11/10*y^54 - 11/10*y", "y^108 + 11/10*x^54 - 11/10*x"}));
  const EquationSystem more_variables =
      read("3 8\n x11*x22 - x21*x12;\n x12*x23 - x22*x13;\n x13*x24 - x23*x14;\n");
  EXPECT_EQ(more_variables.variables, (Texts{"x11", "x22", "x21", "x12", "x23", "x13", "x24", "x14"}));
  const EquationSystem factored = read("1 2\n (a-1)*(b - 5) - 21 ;");
  EXPECT_EQ(equations(factored), (Texts{"(a - 1)*(b - 5) - 21"}));
  EXPECT_EQ(equations(read("1 2\n x - 1E9/-8.E-6*y;")), (Texts{"x - (-125000000000000)*y"}));
}

TEST(PhcReader, EveryVariableRangesOverAllReals) {
  const EquationSystem system = read("1 2\n x*y - 1;");
  EXPECT_EQ(system.box, Box(2, Interval::entire()));
  EXPECT_TRUE(system.inequalities.empty());
}

TEST(PhcReader, DecimalsAreExact) {
  EXPECT_EQ(equations(read("1\n 0.1*x - 3.333e-1;")), (Texts{"1/10*x - 3333/10000"}));
  EXPECT_EQ(equations(read("1\n 123456789012345678901234567890*x;")),
            (Texts{"123456789012345678901234567890*x"}));
}

TEST(PhcReader, ZeroTermsSetTheOrderAndAreLeftOut) {
  const EquationSystem system = read("2 3\n z - z + x - x + (y - 2)*(x + y - 1)^2;\n 2*y - z - 2*y;");
  EXPECT_EQ(system.variables, (Texts{"z", "x", "y"}));
  EXPECT_EQ(equations(system), (Texts{"(y - 2)*(x + y - 1)^2", "-z"}));
  EXPECT_EQ(equations(read("1\n x - x;")), (Texts{"0"}));
}

TEST(PhcReader, TheRestOfTheFileIsIgnored) {
  const std::string rest =
      "\nTITLE : \"quoted\" { no end # \x01\xff\n\nTHE SOLUTIONS :\n 1 2\nx : 1.0E+00 2; ";
  EXPECT_EQ(equations(read("1\n x^2 - 2;" + rest)), (Texts{"x^2 - 2"}));
}

TEST(PhcReader, CommentsInBracesAreSkipped) {
  EXPECT_EQ(equations(read("1 { one\n equation }\n x { * 3 } - 2;")), (Texts{"x - 2"}));
  EXPECT_EQ(error("1\n x - { 2;").substr(0, 8), "a.phc:2:");
}

TEST(PhcReader, ImaginaryPartsMustVanish) {
  EXPECT_EQ(equations(read("1\n x - i*i*2;")), (Texts{"x - (-2)"}));
  EXPECT_EQ(equations(read("1\n (1.5 + 0.0E+00*i)*x + (1 - i)*(1 + I);")), (Texts{"3/2*x + 2"}));
  EXPECT_EQ(equations(read("1\n x + i - i;")), (Texts{"x"}));
  EXPECT_EQ(error("2 1\n x - 1;\n x -\n 2*i;"),
            "a.phc:4: polynomial 2 has an imaginary part; expected real coefficients");
  EXPECT_NE(error("1\n (x + i*y)*(x - i);").find("one variable more than the 1"), std::string::npos);
  EXPECT_NE(error("1\n (x + i)^1000;").find("real coefficients"), std::string::npos);
}

TEST(PhcReader, LaurentExponentsAreRead) {
  EXPECT_EQ(equations(read("1\n x^-1 - 2 + x^(2) + x**(-3);")), (Texts{"x^(-1) - 2 + x^2 + x^(-3)"}));
  // Leaving out x^-1 - x^-1 would enlarge the domain.
  EXPECT_EQ(equations(read("1\n x^-1 - x^-1 + x;")), (Texts{"x^(-1) - x^(-1) + x"}));
}

TEST(PhcReader, ForbiddenNamesGetUnderscores) {
  EXPECT_EQ(read("1 4\n x[1] + x_1_ + y.2' + sin;").variables, (Texts{"x_1_", "x_1__", "y_2_", "sin_"}));
}

TEST(PhcReader, MistakesNameTheLineAndWhatWasExpected) {
  EXPECT_EQ(error(""), "a.phc:1: expected the number of equations, not the end of the file");
  EXPECT_EQ(error("x;"), "a.phc:1: expected the number of equations, not 'x'");
  EXPECT_EQ(error("1.5\nx;"), "a.phc:1: expected the number of equations, not '1.5'");
  EXPECT_EQ(error("-1\nx;"), "a.phc:1: expected the number of equations, not '-'");
  EXPECT_EQ(error("2\n x - 1;\n"), "a.phc:3: expected polynomial 2 of 2, not the end of the file");
  EXPECT_EQ(error("1\n x - 1"), "a.phc:2: expected ';' after polynomial 1, not the end of the file");
  EXPECT_EQ(error("1\n 2x;"), "a.phc:2: expected ';' after polynomial 1, not 'x'");
  EXPECT_EQ(error("1\n (x - 1;"), "a.phc:2: expected ')' after the sum in parentheses, not ';'");
  EXPECT_EQ(error("1 2\n x^2 - 1;"), "a.phc:1: announces 2 variables, but only 1 appear in the polynomials");
  EXPECT_EQ(error("1\n x - e;"), "a.phc:2: 'e' belongs to numbers (1.0E-2); expected another name");
  EXPECT_NE(error("1\n x - -2;").find("write x - (-2)"), std::string::npos);
  EXPECT_NE(error("1\n x*-2;").find("expected a number, a variable or '('"), std::string::npos);
  EXPECT_NE(error("1\n x^2^3;").find("(x^2)^3"), std::string::npos);
  EXPECT_NE(error("1\n x^y;").find("integer exponent"), std::string::npos);
  EXPECT_NE(error("1\n x^0.5;").find("integer exponent"), std::string::npos);
  EXPECT_NE(error("1 2\n x/y;").find("no other quotients"), std::string::npos);
  EXPECT_NE(error("1\n x/0;").find("division by the constant 0"), std::string::npos);
}

TEST(PhcReader, HostileInputIsRefusedAndNotFollowed) {
  EXPECT_NE(error("1\n" + std::string(100'000, '(')).find("nested too deeply"), std::string::npos);
  EXPECT_NE(error("1\n x^99999999999999999999;").find("exponent"), std::string::npos);
  EXPECT_NE(error("1\n (1+1/3)^1000000*x;").find("bits"), std::string::npos);
  EXPECT_NE(error("1\n 1e999999*x;").find("beyond"), std::string::npos);
  EXPECT_NE(error("999999999999999999999\n x;").find("number of equations"), std::string::npos);
  EXPECT_NE(error(std::string("1\n x \0 2;", 9)).find("\\x00"), std::string::npos);
  EXPECT_NE(error("1\n x\xc3\xa9;").find("\\xc3"), std::string::npos);
}

TEST(PhcReader, ASumOfManyTermsIsReadAndPrinted) {
  std::string text = "1\n x";
  for (int i = 0; i < 200'000; ++i) text += "+2";
  EXPECT_EQ(equations(read(text + ";")).front().size(), 1 + 200'000 * 4U);
}

}  // namespace
}  // namespace gcslab
