// What the problem files say of themselves is true.

#include "experiments/corpus/corpus.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "experiments/corpus/problem.h"
#include "experiments/corpus/random_polynomial.h"
#include "expression/differentiate.h"
#include "expression/tape_evaluator.h"
#include "interval/mpfr_interval.h"
#include "interval/point_numbers.h"

namespace gcslab {
namespace {

std::vector<CorpusEntry> function_problems() {
  std::vector<CorpusEntry> result;
  for (const CorpusEntry& entry : Corpus::standard().problems()) {
    for (const std::string& kind : function_kinds()) {
      if (kind_of_file(entry.path) == kind) result.push_back(entry);
    }
  }
  return result;
}

TEST(Corpus, EveryFileLoadsAndIsNamedAfterItsFile) {
  ASSERT_GT(function_problems().size(), 20u);
  for (const CorpusEntry& entry : function_problems()) {
    const Problem problem = load_problem(entry.path);
    EXPECT_EQ(problem.name, entry.path.stem()) << entry.path;
    EXPECT_FALSE(problem.title.empty()) << entry.path;
  }
}

/// Values of all expressions at a rational point, enclosed to 200 bits; exactly 0 only when the enclosure is.
std::vector<Interval> values_at(const std::vector<Expression>& expressions,
                                const std::vector<Rational>& point) {
  const NumberTraits<MpfrInterval>::Scope scope(200);
  const Tape tape(expressions, static_cast<int>(point.size()));
  TapeEvaluator<MpfrInterval> evaluator(tape);
  std::vector<MpfrInterval> arguments;
  for (const Rational& coordinate : point)
    arguments.push_back(NumberTraits<MpfrInterval>::from_rational(coordinate));
  evaluator.evaluate(arguments);
  std::vector<Interval> values;
  for (std::size_t i = 0; i < expressions.size(); ++i) {
    values.push_back(NumberTraits<MpfrInterval>::enclosure(evaluator.value(i)));
  }
  return values;
}

TEST(Corpus, KnownPointsLieOnTheSetAndInTheBox) {
  for (const CorpusEntry& entry : function_problems()) {
    const Problem problem = load_problem(entry.path);
    const auto targets = problem.targets();
    for (const auto& point : problem.known.points) {
      for (const BoundTarget& target : targets) {
        if (target.is_polynomial()) {
          EXPECT_EQ(target.polynomial().evaluate(point), 0) << entry.name;
        }
      }
      for (const Interval& value : values_at(problem.system.equations, point)) {
        EXPECT_TRUE(contains(value, 0)) << entry.name;
      }
      for (std::size_t i = 0; i < point.size(); ++i) {
        EXPECT_TRUE(contains(problem.system.box[i], point[i].get_d())) << entry.name;
      }
    }
  }
}

TEST(Corpus, KnownSingularPointsHaveDependentGradients) {
  for (const CorpusEntry& entry : function_problems()) {
    const Problem problem = load_problem(entry.path);
    const auto targets = problem.targets();
    const int n = static_cast<int>(problem.system.variables.size());
    for (const auto& point : problem.known.singular) {
      std::vector<std::vector<Rational>> gradients;
      for (const BoundTarget& target : targets) {
        std::vector<Rational> row;
        for (int i = 0; i < n; ++i) row.push_back(target.polynomial().derivative(i).evaluate(point));
        gradients.push_back(row);
      }
      if (gradients.size() == 1) {
        for (const Rational& partial : gradients[0]) EXPECT_EQ(partial, 0) << entry.name;
      } else {  // two gradients in space: their cross product vanishes
        const auto& a = gradients[0];
        const auto& b = gradients[1];
        EXPECT_EQ(a[1] * b[2], a[2] * b[1]) << entry.name;
        EXPECT_EQ(a[2] * b[0], a[0] * b[2]) << entry.name;
        EXPECT_EQ(a[0] * b[1], a[1] * b[0]) << entry.name;
      }
    }
  }
}

TEST(Corpus, SuitesNameProblemsThatExist) {
  for (const CorpusEntry& suite : Corpus::standard().suites()) {
    EXPECT_FALSE(Corpus::standard().expand("suite:" + suite.name).empty());
  }
}

TEST(Corpus, MisspeltNamesGetTheNearest) {
  try {
    static_cast<void>(Corpus::standard().problem_path("curves/folum"));
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("did you mean 'curves/folium'"), std::string::npos);
  }
}

TEST(RandomPolynomial, IsTheSameOnEveryMachine) {
  const Polynomial p = random_polynomial({2, 10, "kostlan", 1});
  EXPECT_EQ(p.total_degree(), 10);
  EXPECT_EQ(p.terms().size(), 66u);
  // Printed by the first version of the generator; a change here would change every published count.
  EXPECT_EQ(p.coefficient({0, 0}).get_str(), "983549/1048576");
  EXPECT_EQ(p.coefficient({3, 4}).get_str(), "-4679634782742669/140737488355328");
}

}  // namespace
}  // namespace gcslab
