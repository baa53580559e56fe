// Searches from one point: where they must end, by exact iterates, exact minima, and lengths measured on the
// figures that they find.

#include "local_search/local_search.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "geometry/constraint_system_reader.h"
#include "geometry/sketch.h"
#include "homotopy/starting_figure.h"
#include "local_search/newton_raphson.h"
#include "local_search/sum_of_squares.h"
#include "support/fuzz.h"
#include "support/planted_system.h"

namespace gcslab {
namespace {

using planted::system_of;

constexpr auto kMinimisers = {Minimiser::levenberg_marquardt, Minimiser::bfgs};
constexpr LocalSearchOptions kLimits = {1000, 1e-10};

LocalSearch newton(const EquationSystem& system, std::vector<double> start, bool is_damped = false,
                   std::uint64_t iterations = 100) {
  return newton_raphson(SystemFunctions(system), std::move(start), {{iterations, 1e-10}, is_damped});
}

LocalSearch minimised(const EquationSystem& system, std::vector<double> start, Minimiser minimiser) {
  return minimise_squares(SystemFunctions(system), std::move(start), minimiser, kLimits);
}

TEST(NewtonRaphson, TakesTheFullStep) {
  const EquationSystem square = system_of({"x"}, {"x^2 - 2"});
  const LocalSearch one = newton(square, {1}, false, 1);
  EXPECT_EQ(one.point, std::vector<double>{1.5});  // (x + 2 / x) / 2
  EXPECT_EQ(one.end, LocalSearchEnd::budget);
  EXPECT_EQ(one.residual, 0.25);
  const LocalSearch root = newton(square, {1});
  EXPECT_EQ(root.end, LocalSearchEnd::root);
  EXPECT_NEAR(root.point[0], std::sqrt(2), 1e-9);
}

TEST(NewtonRaphson, CyclesForEverWithoutDamping) {
  const EquationSystem cubic = system_of({"x"}, {"x^3 - 2*x + 2"});  // 0, 1, 0, 1, ...
  const LocalSearch cycle = newton(cubic, {0});
  EXPECT_EQ(cycle.end, LocalSearchEnd::budget);
  EXPECT_EQ(cycle.iterations, 100U);
  EXPECT_EQ(cycle.point[0], 0);
  // Damped, it is caught at the local minimum of |f| on this side, sqrt(2/3), and says so.
  const LocalSearch caught = newton(cubic, {0}, true);
  EXPECT_TRUE(caught.end == LocalSearchEnd::stalled || caught.end == LocalSearchEnd::singular ||
              caught.end == LocalSearchEnd::budget);
  EXPECT_NEAR(caught.point[0], std::sqrt(2.0 / 3), 1e-3);
}

TEST(NewtonRaphson, ConvergesByDampingWhereTheFullStepDoesNot) {
  const EquationSystem arc = system_of({"x"}, {"atan(x)"});
  EXPECT_NE(newton(arc, {3}).end, LocalSearchEnd::root);
  const LocalSearch root = newton(arc, {3}, true);
  EXPECT_EQ(root.end, LocalSearchEnd::root);
  EXPECT_NEAR(root.point[0], 0, 1e-9);
}

TEST(NewtonRaphson, TellsWhyItEnds) {
  EXPECT_EQ(newton(system_of({"x", "y"}, {"x + y - 1", "x + y - 2"}), {0, 0}).end, LocalSearchEnd::singular);
  EXPECT_EQ(newton(system_of({"x"}, {"x^2 - 1"}), {0}).end, LocalSearchEnd::singular);
  // From 100 the step of sqrt(x) = 1/10 leads to -98.
  const LocalSearch undefined = newton(system_of({"x"}, {"sqrt(x) - 0.1"}), {100});
  EXPECT_EQ(undefined.end, LocalSearchEnd::undefined);
  EXPECT_NEAR(undefined.point[0], -98, 1e-9);
  EXPECT_NE(end_text(undefined).find("after 1 iteration where an equation is undefined"), std::string::npos);
  const LocalSearch touching = newton(system_of({"x"}, {"(x - 1)^2"}), {2});  // a double root: half a step
  EXPECT_EQ(touching.end, LocalSearchEnd::root);
  EXPECT_NEAR(touching.point[0], 1, 1e-9);
}

TEST(LocalSearch, DoesNotDependOnUnits) {
  const EquationSystem metres = system_of({"x", "y"}, {"x^2 + y^2 - 25", "x*y - 12"});
  const EquationSystem nanometres =
      system_of({"x", "y"}, {"7*(x^2 + y^2 - 25*10^(-18))", "x*y - 12*10^(-18)"});
  const LocalSearch large = newton(metres, {5, 1}), small = newton(nanometres, {5e-9, 1e-9});
  ASSERT_EQ(large.end, LocalSearchEnd::root);
  ASSERT_EQ(small.end, LocalSearchEnd::root);
  EXPECT_EQ(small.iterations, large.iterations);
  for (std::size_t i = 0; i < 2; ++i) EXPECT_NEAR(small.point[i], 1e-9 * large.point[i], 1e-17);
  const LocalSearch squares = minimised(nanometres, {5e-9, 1e-9}, Minimiser::levenberg_marquardt);
  ASSERT_EQ(squares.end, LocalSearchEnd::root);
  EXPECT_NEAR(squares.point[0] * squares.point[1], 12e-18, 1e-26);
}

TEST(SumOfSquares, EndsAtAMinimumThatIsNoRootAndSaysSo) {
  // Sides 1, 1 and 3: with w = x^2 at the middle point, 2 (w - 1)^2 + (4 w - 9)^2 is least for w = 19/9.
  const EquationSystem triangle =
      system_of({"b", "x", "y"}, {"b^2 - 9", "x^2 + y^2 - 1", "(x - b)^2 + y^2 - 1"});
  for (const Minimiser minimiser : kMinimisers) {
    const LocalSearch search = minimised(triangle, {2, 0.9, 0.7}, minimiser);
    EXPECT_EQ(search.end, LocalSearchEnd::stationary);
    EXPECT_NEAR(search.residual, 10.0 / 9, 1e-4);
    EXPECT_NEAR(search.point[0], 2 * search.point[1], 1e-4);
    EXPECT_NE(end_text(search).find("stationary point of the sum of squares that is no root"),
              std::string::npos);
    for (const double start : {0.0, 1.0})
      EXPECT_EQ(minimised(system_of({"x"}, {"x^2 + 1"}), {start}, minimiser).end, LocalSearchEnd::stationary);
  }
}

TEST(SumOfSquares, TakesSystemsThatAreNotSquare) {
  for (const Minimiser minimiser : kMinimisers) {
    const LocalSearch circle = minimised(system_of({"x", "y"}, {"x^2 + y^2 - 1"}), {2, 1}, minimiser);
    EXPECT_EQ(circle.end, LocalSearchEnd::root);
    EXPECT_NEAR(std::hypot(circle.point[0], circle.point[1]), 1, 1e-9);
    const LocalSearch over =
        minimised(system_of({"x", "y"}, {"x^2 + y^2 - 25", "x*y - 12", "x - y - 1"}), {5, 1}, minimiser);
    EXPECT_EQ(over.end, LocalSearchEnd::root);
    EXPECT_NEAR(over.point[0], 4, 1e-7);
    EXPECT_NEAR(over.point[1], 3, 1e-7);
  }
}

TEST(SumOfSquares, OfAFunctionUndefinedAtTheStartIsNotMinimised) {
  for (const Minimiser minimiser : kMinimisers) {
    const LocalSearch search = minimised(system_of({"x"}, {"sqrt(x) - 1"}), {-1}, minimiser);
    EXPECT_EQ(search.end, LocalSearchEnd::undefined);
    EXPECT_EQ(search.point[0], -1);
  }
}

TEST(LocalSearch, StopsWhenAsked) {
  const SystemFunctions functions(system_of({"x"}, {"x^2 - 2"}));
  std::stop_source source;
  source.request_stop();
  EXPECT_EQ(newton_raphson(functions, {1}, {}, source.get_token()).end, LocalSearchEnd::stopped);
  for (const Minimiser minimiser : kMinimisers)
    EXPECT_EQ(minimise_squares(functions, {1}, minimiser, {}, source.get_token()).end,
              LocalSearchEnd::stopped);
}

// ---- from sketches ----

struct Figured {
  ConstraintSystem system;
  Frame frame;
  GeometricEquations equations;

  SystemFunctions functions() const {
    return SystemFunctions(equation_system(equations, system, frame, system.valuation("")));
  }
};

Figured octahedron() {
  const YamlNode file =
      YamlNode::load_file(std::string(GCSLAB_SOURCE_DIR) + "/data/polyhedra/octahedron.yaml");
  Figured result{read_constraint_system(file), {}, {}};
  result.frame = frame_of(result.system);
  result.equations = geometric_equations(result.system, result.frame);
  return result;
}

void expect_wanted_lengths(const Figured& figured, const std::vector<double>& unknowns) {
  const Figure figure = figure_at(figured.equations, unknowns);
  const std::vector<double> wanted = values_of(figured.system.valuation(""));
  for (const Constraint& edge : figured.system.constraints) {
    const auto &a = figure[edge.objects[0]], &b = figure[edge.objects[1]];
    EXPECT_NEAR(std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]), wanted[*edge.parameter], 1e-7);
  }
}

TEST(LocalSearch, FromSketchesFindsFiguresWithTheWantedLengths) {
  const Figured figured = octahedron();
  const SystemFunctions functions = figured.functions();
  std::array<int, 3> found{};
  for (std::size_t seed = 0; seed < fuzz_cases(20); ++seed) {
    ConstraintSystem drawn = figured.system;
    drawn.random_sketch = seed;
    const std::vector<double> start =
        drawn_unknowns(figured.system, figured.frame, figured.equations, *sketch_of(drawn));
    const std::array<LocalSearch, 3> searches = {
        newton_raphson(functions, start, {}),
        minimise_squares(functions, start, Minimiser::levenberg_marquardt, kLimits),
        minimise_squares(functions, start, Minimiser::bfgs, kLimits)};
    for (std::size_t k = 0; k < searches.size(); ++k) {
      if (searches[k].end != LocalSearchEnd::root) continue;
      ++found[k];
      expect_wanted_lengths(figured, searches[k].point);
    }
  }
  for (const int count : found) EXPECT_GT(count, 0);
}

TEST(LocalSearch, FromAFlatSketchStaysFlat) {
  const Figured figured = octahedron();
  Figure flat(6, std::vector<double>(3, 0.0));
  Random random(fuzz_seed(), "flat sketch");
  for (auto& point : flat) {
    for (std::size_t axis = 0; axis < 2; ++axis) point[axis] = random.uniform(-1, 1);
  }
  const SystemFunctions functions = figured.functions();
  const std::vector<double> start = drawn_unknowns(figured.system, figured.frame, figured.equations, flat);
  const LocalSearch stuck = newton_raphson(functions, start, {});
  EXPECT_EQ(stuck.end, LocalSearchEnd::singular);  // no equation sees a point leave the plane
  EXPECT_EQ(stuck.iterations, 0U);
  for (const Minimiser minimiser : kMinimisers) {
    const LocalSearch search = minimise_squares(functions, start, minimiser, kLimits);
    EXPECT_NE(search.end, LocalSearchEnd::root);  // the lengths are those of no flat figure
    for (const std::vector<double>& point : figure_at(figured.equations, search.point))
      EXPECT_NEAR(point[2], 0, 1e-12);
  }
}

}  // namespace
}  // namespace gcslab
