#include <cstdlib>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "base/random.h"
#include "expression/bertini_writer.h"
#include "expression/json_writer.h"
#include "expression/minibex_reader.h"
#include "expression/minibex_writer.h"
#include "expression/parser.h"
#include "expression/phc_reader.h"
#include "expression/phc_writer.h"
#include "expression/printer.h"
#include "expression/tape_evaluator.h"
#include "interval/fast_interval.h"
#include "interval/point_numbers.h"
#include "support/error_text.h"
#include "support/fuzz.h"
#include "support/random_expression.h"
#include "support/random_interval.h"

namespace gcslab {
namespace {

using Texts = std::vector<std::string>;

EquationSystem make(const Texts& variables, const Texts& equations, const Texts& inequalities = {}) {
  EquationSystem system;
  system.variables = variables;
  for (const std::string& text : equations) {
    system.equations.push_back(parse_equation(*system.graph, text, variables));
  }
  for (const std::string& text : inequalities) {
    system.inequalities.push_back(parse_inequality(*system.graph, text, variables));
  }
  system.box.assign(variables.size(), Interval(-1, 2));
  return system;
}

EquationSystem random_system(Vocabulary vocabulary, Random& random) {
  EquationSystem system;
  system.variables = {"x", "e1", "y_2", "sum"};
  RandomExpressions expressions(*system.graph, 4, vocabulary, random);
  for (int i = 0; i < 3; ++i) system.equations.push_back(expressions.draw(5));
  system.inequalities.push_back(expressions.draw(3));
  for (int i = 0; i < 4; ++i) system.box.push_back(Interval::entire());
  return system;
}

std::vector<Rational> random_point(Random& random) {
  std::vector<Rational> point;
  for (int i = 0; i < 4; ++i) {
    Rational value(random.integer(-30, 30), random.integer(1, 9));
    value.canonicalize();
    point.push_back(value);
  }
  return point;
}

/// Values of all expressions, or what is wrong with the point.
std::string values(const std::vector<Expression>& expressions, const std::vector<Rational>& point) {
  try {
    const Tape tape(expressions, static_cast<int>(point.size()));
    TapeEvaluator<Rational> evaluator(tape);
    evaluator.evaluate(point);
    std::string result;
    for (std::size_t i = 0; i < expressions.size(); ++i) result += evaluator.value(i).get_str() + " ";
    return result;
  } catch (const NotApplicable&) {
    return "undefined";
  }
}

Texts texts(const std::vector<Expression>& expressions, const EquationSystem& system) {
  Texts result;
  for (const Expression& expression : expressions) result.push_back(to_text(expression, system.variables));
  return result;
}

TEST(PhcWriter, WhatIsReadBackHasTheSameValues) {
  const std::uint64_t seed = fuzz_seed();
  Random random(seed, "phc round trip");
  for (std::size_t i = 0; i < fuzz_cases(300); ++i) {
    const EquationSystem system = random_system(Vocabulary::polynomial, random);
    const std::string text = write_phc(system);
    const EquationSystem back = read_phc(text, "a.phc");
    EXPECT_EQ(back.variables, (Texts{"x", "v_e1", "y_2", "sum"})) << text;
    for (int k = 0; k < 5; ++k) {
      const std::vector<Rational> point = random_point(random);
      EXPECT_EQ(values(back.equations, point), values(system.equations, point)) << text;
    }
  }
}

TEST(PhcWriter, WritesWhatPhcReads) {
  const EquationSystem system = make({"x", "y"}, {"(x - 1)*y*3/7 - x^2", "-2*x + (x + y)*5 = 1/3"});
  const std::string text = write_phc(system);
  EXPECT_EQ(text.substr(0, text.find("\nTITLE")),
            "2\n (1/7)*((x - 1)*y*(3)) - x^2;\n (-2)*x + (x + y)*(5) - (1/3);\n");
}

TEST(PhcWriter, TheOrderOfTheVariablesIsKept) {
  const EquationSystem system = make({"a", "b", "unused"}, {"b - a", "a*b"});
  const std::string text = write_phc(system);
  EXPECT_EQ(text.substr(0, text.find(';')), "2 3\n a-a+b-b+unused-unused + b - a");
  EXPECT_EQ(read_phc(text, "").variables, system.variables);
  EXPECT_EQ(texts(read_phc(text, "").equations, system), (Texts{"b - a", "a*b"}));
}

TEST(PhcWriter, NumbersOfManyDigitsKeepAllOfThem) {
  const EquationSystem system = make({"x"}, {"123456789012345678901200*x - 1/1234567890123456789012"});
  const std::string text = write_phc(system);
  EXPECT_NE(text.find("1.234567890123456789012E+23*x"), std::string::npos) << text;
  EXPECT_NE(text.find("(1/1.234567890123456789012E+21)"), std::string::npos) << text;
  EXPECT_EQ(texts(read_phc(text, "").equations, system), texts(system.equations, system));
}

TEST(PhcWriter, SaysWhatItLeavesOutAndRenames) {
  const std::string text = write_phc(make({"i", "x"}, {"i*x - 1"}, {"x <= 1"}));
  EXPECT_NE(text.find("v_i*x - 1;"), std::string::npos) << text;
  EXPECT_NE(text.find("v_i stands for i"), std::string::npos);
  EXPECT_NE(text.find("1 inequalities are not written"), std::string::npos);
}

TEST(PhcWriter, RefusesWhatIsNoPolynomialWithTheReason) {
  const auto reason = [](const std::string& equation) {
    return error_text([&] { write_phc(make({"x", "y"}, {"x = y", equation})); });
  };
  EXPECT_EQ(reason("sin(x)"), "PHCpack has polynomials only, but equation 2 contains sin");
  EXPECT_NE(reason("x*pi").find("pi, which is no rational number"), std::string::npos);
  EXPECT_NE(reason("x/y").find("a division"), std::string::npos);
  EXPECT_NE(reason("x^(-2)").find("the power -2"), std::string::npos);
  EXPECT_NE(reason("x^(2/3)").find("the power 2/3"), std::string::npos);
  EXPECT_NE(reason("1e400*x").find("401 digits"), std::string::npos);
}

TEST(BertiniWriter, WritesAffineVariablesAndFunctions) {
  const std::string text = write_bertini(make({"x", "_y", "f1", "I"}, {"-x + _y/3 = -1/2", "f1*I*pi - x^3"}));
  EXPECT_EQ(text.substr(text.find("CONFIG")),
            "CONFIG\nEND;\n\nINPUT\nvariable_group x, v__y, f1, v_I;\nfunction f_1, f_2;\n\n"
            "f_1 = (-x) + v__y/3 - (-1/2);\nf_2 = f1*v_I*Pi - x^3;\nEND;\n");
  EXPECT_NE(text.find("% v__y stands for _y\n% v_I stands for I\n"), std::string::npos);
  EXPECT_NE(error_text([] { write_bertini(make({"x"}, {"exp(x)"})); }).find("contains exp"),
            std::string::npos);
}

TEST(MinibexWriter, WhatIsReadBackIsTheSameSystem) {
  const std::uint64_t seed = fuzz_seed();
  Random random(seed, "minibex round trip");
  for (std::size_t i = 0; i < fuzz_cases(300); ++i) {
    const EquationSystem system = random_system(Vocabulary::transcendental, random);
    const std::string text = write_minibex(system);
    EquationSystem back = read_minibex(text, "a.bch");
    EXPECT_EQ(back.variables, (Texts{"x", "e1", "y_2", "v_sum"}));
    back.variables = system.variables;
    EXPECT_EQ(texts(back.equations, back), texts(system.equations, system)) << text;
    EXPECT_EQ(texts(back.inequalities, back), texts(system.inequalities, system)) << text;
  }
}

TEST(MinibexWriter, WhatIsReadBackHasTheSameValues) {
  const std::uint64_t seed = fuzz_seed();
  Random random(seed, "minibex values");
  for (std::size_t i = 0; i < fuzz_cases(200); ++i) {
    const EquationSystem system = random_system(Vocabulary::rational, random);
    const EquationSystem back = read_minibex(write_minibex(system), "a.bch");
    const std::vector<Rational> point = random_point(random);
    EXPECT_EQ(values(back.equations, point), values(system.equations, point));
    EXPECT_EQ(values(back.inequalities, point), values(system.inequalities, point));
  }
}

TEST(MinibexWriter, BoxesAreReadBackToTheLastBit) {
  const std::uint64_t seed = fuzz_seed();
  Random random(seed, "minibex boxes");
  const double infinity = std::numeric_limits<double>::infinity();
  const double smallest = std::numeric_limits<double>::denorm_min();
  const double largest = std::numeric_limits<double>::max();
  Box boxes = {Interval::entire(),          Interval(-infinity, 0.1),
               Interval(smallest, largest), Interval(-largest, -smallest),
               Interval(0.1, 0.1),          Interval(1e300),
               Interval(1.5e-310),          Interval(-0.0, 0.0),
               Interval(1e22, 1e23)};
  for (std::size_t i = 0; i < fuzz_cases(300); ++i) {
    const Interval drawn = random_interval(random);
    if (!is_empty(drawn)) boxes.push_back(drawn);
  }
  for (const Interval& side : boxes) {
    EquationSystem system = make({"x"}, {"x"});
    system.box = {side};
    EXPECT_EQ(read_minibex(write_minibex(system), "a.bch").box, system.box) << write_minibex(system);
  }
}

TEST(MinibexWriter, OddRootsAreDefinedForNegativeNumbersToo) {
  const EquationSystem system =
      make({"x"}, {"cbrt(x)", "x^(5/3)", "x^(2/3)", "x^(-1/3)", "x^(-2/5)", "sqrt(x^2 + 1)^(1/3)"});
  const EquationSystem back = read_minibex(write_minibex(system), "a.bch");
  const UpwardRounding scope;
  for (const double x : {-8.0, -1.0, -0.125, 0.3, 27.0}) {
    for (std::size_t i = 0; i < system.equations.size(); ++i) {
      const Tape expected_tape(system.equations[i], 1);
      const Tape tape(back.equations[i], 1);
      TapeEvaluator<FastInterval> expected(expected_tape);
      TapeEvaluator<FastInterval> found(tape);
      expected.evaluate(std::vector<FastInterval>{FastInterval(x, x)});
      found.evaluate(std::vector<FastInterval>{FastInterval(x, x)});
      const Interval common = intersection(expected.value().interval(), found.value().interval());
      EXPECT_FALSE(is_empty(common)) << i << " at " << x;
      EXPECT_LT(width(hull(expected.value().interval(), found.value().interval())), 1e-13)
          << i << " at " << x;
    }
  }
}

TEST(JsonWriter, IsExact) {
  EquationSystem system = make({"x", "y"}, {"x^2/3 + sin(y) = 0.1"}, {"x <= y"});
  system.box = {Interval(0.1, 0.3), Interval(-1, std::numeric_limits<double>::infinity())};
  const nlohmann::json json = nlohmann::json::parse(write_json(system));
  EXPECT_EQ(json["format"], "gcslab-system");
  EXPECT_EQ(json["variables"], (Texts{"x", "y"}));
  EXPECT_EQ(parse_expression(*system.graph, json["equations"][0].get<std::string>(), system.variables),
            system.equations[0]);
  EXPECT_EQ(parse_expression(*system.graph, json["inequalities"][0].get<std::string>(), system.variables),
            system.inequalities[0]);
  EXPECT_EQ(std::strtod(json["box"]["x"][0].get<std::string>().c_str(), nullptr), 0.1);
  EXPECT_EQ(json["box"]["x"][1], "0x1.3333333333333p-2");
  EXPECT_EQ(json["box"]["y"][1], "inf");
}

TEST(Writers, PartsThatAreSharedManyTimesAreNotWrittenOut) {
  EquationSystem system = make({"x"}, {"x + 1"});
  for (int i = 0; i < 100; ++i) system.equations[0] = system.equations[0] * system.equations[0];
  EXPECT_NE(error_text([&] { write_json(system); }).find("characters"), std::string::npos);
  EXPECT_NE(error_text([&] { write_phc(system); }).find("characters"), std::string::npos);
  EXPECT_NE(error_text([&] { write_minibex(system); }).find("characters"), std::string::npos);
}

}  // namespace
}  // namespace gcslab
