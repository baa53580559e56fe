// The homotopy of a sketch: its derivatives, its enclosures, and what holds at t = 0 and t = 1.

#include "homotopy/homotopy.h"

#include <cmath>
#include <gtest/gtest.h>

#include "base/random.h"
#include "homotopy/interval_curve.h"
#include "homotopy/precise_homotopy.h"
#include "interval/rational.h"
#include "support/corpus_figure.h"
#include "support/fuzz.h"

namespace gcslab {
namespace {

std::vector<double> random_point(std::size_t size, Random& random) {
  std::vector<double> v(size);
  for (double& x : v) x = random.uniform(-1, 1);
  return v;
}

/// Squared distances, norms with angles, volumes, balanced and perturbed.
const std::vector<std::string> kFigures = {"polyhedra/octahedron", "polyhedra/hexahedron",
                                           "polyhedra/6p7d3a2c", "sketches/lines-touching-four-spheres"};

TEST(Homotopy, HasTheDerivativesThatDifferencesShowForEveryPath) {
  const CorpusFigure pentahedron = corpus_figure("polyhedra/pentahedron");
  Random random(fuzz_seed(), "homotopy");
  for (const bool is_compact : {false, true}) {
    std::vector<double> sketch;
    for (std::size_t p = 0; p < pentahedron.system.parameters.size(); ++p)
      sketch.push_back(random.uniform(0.5, 2));
    const std::vector<double> wanted = pentahedron.wanted();
    Homotopy homotopy(pentahedron.equations,
                      is_compact ? compact_support_path(sketch, wanted, 3) : linear_path(sketch, wanted));
    const std::size_t m = homotopy.size();
    for (std::size_t n = 0; n < fuzz_cases(20); ++n) {
      std::vector<double> v(m + 1), values(m), above(m), below(m);
      for (double& x : v) x = random.uniform(-1, 1);
      Matrix<double> derivatives(m, m + 1);
      ASSERT_TRUE(homotopy.jacobian(v, values, derivatives));
      for (std::size_t j = 0; j <= m; ++j) {
        const double h = 1e-6, x = v[j];
        v[j] = x + h;
        ASSERT_TRUE(homotopy.values(v, above));
        v[j] = x - h;
        ASSERT_TRUE(homotopy.values(v, below));
        v[j] = x;
        for (std::size_t k = 0; k < m; ++k)
          ASSERT_NEAR(derivatives(k, j), (above[k] - below[k]) / (2 * h), 1e-7);
      }
    }
  }
}

TEST(ParameterPath, GoesFromTheSketchToWhatIsWanted) {
  const std::vector<double> sketch = {1, 2.5, 0.1}, wanted = {3, 0.3, 0.7};
  for (const auto& path : {linear_path(sketch, wanted), compact_support_path(sketch, wanted, 1)}) {
    std::vector<double> values(3), derivatives(3), other(3), unused(3);
    path->at(0, values, derivatives);
    EXPECT_EQ(values, sketch);
    path->at(1, values, derivatives);
    EXPECT_EQ(values, wanted);
    for (const double t : {-2.0, 0.3, 1.7}) {
      path->at(t, values, derivatives);
      path->at(t + 1e-6, other, unused);
      for (std::size_t p = 0; p < 3; ++p) EXPECT_NEAR(derivatives[p], (other[p] - values[p]) / 1e-6, 1e-5);
    }
  }
  std::vector<double> values(3), derivatives(3);
  for (const double t : {-5.0, 6.0}) {
    compact_support_path(sketch, wanted, 1)->at(t, values, derivatives);
    EXPECT_LT(values[1], 0);  // a length that no figure has
  }
}

TEST(Homotopy, OfEveryKindOfConstraintHasTheDerivativesThatDifferencesShow) {
  Random random(fuzz_seed(), "homotopies of sketches");
  for (const std::string& name : kFigures) {
    const CorpusFigure figured = corpus_figure(name);
    for (const Booleans booleans : {Booleans::perturbed, Booleans::projected, Booleans::kept}) {
      SketchHomotopy homotopy = figured.homotopy(figured.random_sketch(5), {.booleans = booleans});
      Homotopy& curve = homotopy.curve();
      const auto differences = with_forward_differences(curve);
      const std::size_t m = curve.size();
      Matrix<double> exact(m, m + 1), rough(m, m + 1);
      std::vector<double> values(m);
      for (std::size_t n = 0; n < fuzz_cases(5); ++n) {
        const std::vector<double> v = random_point(m + 1, random);
        ASSERT_TRUE(curve.jacobian(v, values, exact)) << name;
        ASSERT_TRUE(differences->jacobian(v, values, rough)) << name;
        for (std::size_t k = 0; k < m; ++k) {
          for (std::size_t j = 0; j <= m; ++j)
            ASSERT_NEAR(exact(k, j), rough(k, j), 1e-5 * (1 + std::abs(exact(k, j)))) << name;
        }
      }
    }
  }
}

TEST(IntervalHomotopy, EnclosesValuesAndDerivatives) {
  Random random(fuzz_seed(), "interval homotopy");
  for (const std::string& name : kFigures) {
    const CorpusFigure figured = corpus_figure(name);
    SketchHomotopy homotopy = figured.homotopy(figured.random_sketch(3));
    Homotopy& curve = homotopy.curve();
    IntervalHomotopy enclosure(figured.equations, curve);
    const std::size_t m = curve.size();
    std::vector<double> values(m);
    Matrix<double> derivatives(m, m + 1);
    for (std::size_t n = 0; n < fuzz_cases(5); ++n) {
      const std::vector<double> v = random_point(m + 1, random);
      ASSERT_TRUE(curve.jacobian(v, values, derivatives));
      const NumberTraits<FastInterval>::Scope scope;
      // Wide enough for the rounding errors of the doubles that are compared.
      constexpr double kWide = 1e-9;
      std::vector<FastInterval> box, ranges(m);
      for (const double x : v) box.emplace_back(x - kWide, x + kWide);
      Matrix<FastInterval> slopes(m, m + 1);
      ASSERT_TRUE(enclosure.values(box, ranges)) << name;
      ASSERT_TRUE(enclosure.jacobian(box, slopes)) << name;
      for (std::size_t k = 0; k < m; ++k) {
        ASSERT_TRUE(contains(ranges[k].interval(), values[k])) << name << " equation " << k;
        for (std::size_t j = 0; j <= m; ++j) {
          const Interval slope = slopes(k, j).interval();
          const double slack = 1e-13 * (1 + std::abs(derivatives(k, j)));  // of constant derivatives
          ASSERT_TRUE(slope.lower - slack <= derivatives(k, j) && derivatives(k, j) <= slope.upper + slack)
              << name << " equation " << k << " coordinate " << j;
        }
      }
    }
  }
}

/// Points far from the origin beside each other, against exact rationals: doubles lose the distances.
TEST(PreciseHomotopy, KeepsWhatCancels) {
  const CorpusFigure octahedron = corpus_figure("polyhedra/octahedron");
  SketchHomotopy homotopy = octahedron.homotopy(octahedron.random_sketch(1));
  Homotopy& curve = homotopy.curve();
  PreciseHomotopy precise(octahedron.equations, curve);
  Random random(fuzz_seed(), "precise homotopy");
  std::vector<double> v(curve.size() + 1), rough(curve.size()), exact_enough(curve.size());
  double lost = 0;
  for (std::size_t n = 0; n < fuzz_cases(20); ++n) {
    for (double& x : v) x = 1e6 + 1e-3 * random.unit();
    v.back() = 0;  // the parameters are those of the sketch
    ASSERT_TRUE(curve.values(v, rough));
    ASSERT_TRUE(precise.values(v, exact_enough));
    std::vector<Rational> x;
    for (std::size_t i = 0; i < curve.size(); ++i)
      x.push_back(rational_from_double(curve.unit(i)) * rational_from_double(v[i]));
    std::vector<double> parameters(octahedron.system.parameters.size()), speeds(parameters.size());
    curve.path().at(0, parameters, speeds);
    for (const double p : parameters) x.push_back(rational_from_double(p));
    for (std::size_t k = 0; k < curve.size(); ++k) {
      const Tape tape(octahedron.equations.equations[k], static_cast<int>(x.size()));
      TapeEvaluator<Rational> evaluator(tape);
      evaluator.evaluate(x);
      const double expected = curve.weights()[k] * nearest_double(evaluator.value());
      EXPECT_NEAR(exact_enough[k], expected, 1e-14 * std::abs(expected));
      lost = std::max(lost, std::abs(rough[k] - expected));
    }
  }
  EXPECT_GT(lost, 1e-6);
}

/// H vanishes at the sketch, and at t = 1 it is the wanted system, however boolean constraints are treated.
TEST(SketchHomotopy, LeadsFromTheSketchToTheWantedEquations) {
  Random random(fuzz_seed(), "ends of homotopies");
  for (const std::string& name : kFigures) {
    const CorpusFigure figured = corpus_figure(name);
    const SystemFunctions functions(figured.equation_system());
    for (const Booleans booleans : {Booleans::perturbed, Booleans::projected, Booleans::kept}) {
      SketchHomotopy homotopy = figured.homotopy(figured.random_sketch(1), {.booleans = booleans});
      Homotopy& curve = homotopy.curve();
      std::vector<double> values(curve.size());
      ASSERT_TRUE(curve.values(homotopy.start(), values));
      for (const double x : values) EXPECT_NEAR(x, 0, 1e-12) << name;
      std::vector<double> v = random_point(curve.size() + 1, random);
      v.back() = 1;
      ASSERT_TRUE(curve.values(v, values));
      SystemEvaluator<double> wanted(functions);
      std::vector<double> expected(curve.size());
      wanted.values(curve.unknowns(v), expected);
      for (std::size_t k = 0; k < values.size(); ++k)
        EXPECT_NEAR(values[k] / curve.weights()[k], expected[k], 1e-11 * (1 + std::abs(expected[k]))) << name;
    }
  }
}

/// Conditions 1 to 3 of Imbach 2013, section 5.2.2: boolean constraints hold at t = 0 and t = 1 and at no
/// other t.
TEST(SketchHomotopy, LetsPerturbedBooleansHoldAtTheEndsOnly) {
  const CorpusFigure hexahedron = corpus_figure("polyhedra/hexahedron");
  SketchHomotopy homotopy =
      hexahedron.homotopy(hexahedron.random_sketch(2), {.booleans = Booleans::projected, .leading = 0.3});
  const std::vector<EquationOffset>& offsets = homotopy.curve().offsets();
  ASSERT_EQ(offsets.size(), 5U);  // six coplanarities, of which the frame absorbs one
  for (const auto& [equation, start, leading] : offsets) {
    EXPECT_NEAR(start, 0, 1e-12);
    EXPECT_EQ(leading, 0.3);
  }
}

}  // namespace
}  // namespace gcslab
