// A lifted system holds wherever the system does, with its terms at their values, and is made of polynomials.

#include "box_solver/lifted_system.h"

#include <gtest/gtest.h>

#include "expression/printer.h"
#include "interval/mpfr_interval.h"
#include "support/fuzz.h"
#include "support/random_expression.h"
#include "unit/verifier/solved_system.h"

namespace gcslab {
namespace {

const std::vector<std::string> kNames = {"x", "y"};

std::vector<std::string> texts_of(const std::vector<SystemFunction>& functions,
                                  const std::vector<std::string>& names) {
  std::vector<std::string> texts;
  for (const SystemFunction& function : functions) texts.push_back(to_text(function.expression, names));
  return texts;
}

TEST(LiftedSystem, NamesWhatIsNoPolynomial) {
  const Box box(2, Interval(-1, 1));
  const SystemFunctions functions(system_of({"x", "y"}, {"exp(x*y) + sin(x)/y", "y - exp(x*y)*sqrt(x + 2)"},
                                            box, {"cos(exp(x*y)) <= y^-2"}));
  const LiftedSystem lifted(functions);
  std::vector<std::string> terms;
  for (const Term& term : lifted.terms()) terms.push_back(to_text(term.expression, kNames));
  EXPECT_EQ(terms, (std::vector<std::string>{"x*y", "exp(x*y)", "sin(x)", "sin(x)/y", "sqrt(x + 2)",
                                             "cos(exp(x*y))", "y^(-2)"}));
  const std::vector<std::string> names = {"x", "y", "p", "e", "s", "q", "r", "c", "i"};
  EXPECT_EQ(
      texts_of(lifted.functions().equations(), names),
      (std::vector<std::string>{"e + q", "y - e*r", "p - x*y", "q*y - s", "r^2 - (x + 2)", "i*y^2 - 1"}));
  EXPECT_EQ(texts_of(lifted.functions().inequalities(), names), std::vector<std::string>{"c - i"});
  EXPECT_EQ(lifted.terms()[1].argument, 2u);
  EXPECT_EQ(lifted.terms()[2].argument, 0u);
  EXPECT_EQ(lifted.terms()[5].argument, 3u);
  EXPECT_EQ(lifted.terms()[3].argument, std::nullopt);
}

TEST(LiftedSystem, OfPolynomialsIsTheSystemItself) {
  const SystemFunctions functions(
      system_of({"x", "y"}, {"x^3*y - 1/3", "(x + y)^2/7"}, Box(2, Interval(-1, 1))));
  const LiftedSystem lifted(functions);
  EXPECT_TRUE(lifted.terms().empty());
  EXPECT_EQ(&lifted.functions(), &functions);
}

TEST(LiftedSystem, PlacesLeadToTheirTerms) {
  const SystemFunctions functions(
      system_of({"x"}, {"x + 1", "2*exp(cos(x) + x)"}, {{-1, 1}}, {"log(x + 3) <= 1"}));
  for (const auto& [expression, place, argument] : terms_of(functions)) {
    Expression found =
        (place.is_equation ? functions.equations() : functions.inequalities())[place.function].expression;
    for (const int operand : place.operands) found = found.operand(operand);
    EXPECT_EQ(found, expression);
  }
}

MpfrInterval value_at(Expression expression, const std::vector<MpfrInterval>& point) {
  const Tape tape(expression, static_cast<int>(point.size()));
  TapeEvaluator<MpfrInterval> evaluator(tape);
  evaluator.evaluate(point);
  return evaluator.value();
}

Interval enclosure(const MpfrInterval& x) { return NumberTraits<MpfrInterval>::enclosure(x); }

/// Each function at a point, and the lifted ones at that point with the terms at their values there.
TEST(LiftedSystem, HasTheValuesOfTheSystem) {
  constexpr int kVariables = 2;
  Random random(fuzz_seed(), "lifted");
  const NumberTraits<MpfrInterval>::Scope scope(200);
  std::size_t compared = 0, terms = 0;
  for (std::size_t i = 0; i < fuzz_cases(300); ++i) {
    EquationSystem system;
    system.variables = {"x", "y"};
    system.box = Box(kVariables, Interval(-2, 2));
    RandomExpressions expressions(*system.graph, kVariables, Vocabulary::transcendental, random);
    system.equations = {expressions.draw(4), expressions.draw(4)};
    const SystemFunctions functions(system);
    const LiftedSystem lifted(functions);
    std::vector<MpfrInterval> point;
    for (int v = 0; v < kVariables; ++v)
      point.push_back(NumberTraits<MpfrInterval>::from_interval(Interval(random.uniform(-2, 2))));
    std::vector<MpfrInterval> extended = point;
    for (const Term& term : lifted.terms()) extended.push_back(value_at(term.expression, point));
    terms += lifted.terms().size();
    const auto& equations = lifted.functions().equations();
    for (std::size_t k = 0; k < equations.size(); ++k) {
      const Interval above = enclosure(value_at(equations[k].expression, extended));
      const Interval wanted =
          k < 2 ? enclosure(value_at(functions.equations()[k].expression, point)) : Interval(0);
      if (is_empty(above) || is_empty(wanted)) continue;  // undefined there
      EXPECT_FALSE(disjoint(above, wanted)) << to_text(functions.equations()[k % 2].expression, kNames);
      ++compared;
    }
  }
  EXPECT_GT(compared, fuzz_cases(300));
  EXPECT_GT(terms, fuzz_cases(300) / 2);
}

}  // namespace
}  // namespace gcslab
