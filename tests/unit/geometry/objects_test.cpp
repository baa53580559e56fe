// Lines, planes, circles and spheres from text to equations: how they are named, drawn, normalised, moved
// into the frame and bounded, and how mistakes about them are named.

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "geometry/constraint_system_reader.h"
#include "geometry/figure_projection.h"
#include "support/error_text.h"
#include "support/fuzz.h"
#include "unit/geometry/constraint_case.h"

namespace gcslab {
namespace {

std::string in_space() {
  return "universe: 3d\n"
         "points: [A, B, D]\n"
         "lines: [l]\n"
         "planes: [p]\n"
         "circles: [c]\n"
         "spheres: [s]\n"
         "constraints:\n"
         "  - {distance: [A, B], parameter: h}\n"
         "  - {distance: [l, A], parameter: k}\n"
         "  - {incidence: [D, c]}\n"
         "  - {radius: [s], parameter: r}\n"
         "  - {centre: [B, s]}\n"
         "  - {angle: [p, l], parameter: a}\n"
         "valuations: {v: {h: 1, k: 2, r: 3, a: 30 deg}}\n";
}

std::string drawn() {
  return "sketch:\n"
         "  A: [0, 0, 0]\n"
         "  B: [2, 0, 0]\n"
         "  D: [0, 3, 0]\n"
         "  l: {through: [[1, 0, 5], [1, 0, 9]]}\n"
         "  p: {point: [0, 0, 2], normal: [0, 3, 4]}\n"
         "  c: {centre: [0, 1, 0], radius: 2, normal: [0, 0, -7]}\n"
         "  s: {centre: [2, 0, 0], radius: 1.5}\n";
}

ConstraintSystem read(const std::string& text) {
  return read_constraint_system(YamlNode::parse(text, "figure.yaml"));
}

std::string replaced(std::string text, const std::string& old, const std::string& by) {
  const std::size_t place = text.find(old);
  EXPECT_NE(place, std::string::npos) << old;
  return text.replace(place, old.size(), by);
}

TEST(Objects, AreNamedAndDrawn) {
  const ConstraintSystem system = read(in_space() + drawn());
  EXPECT_EQ(system.names(), (std::vector<std::string>{"A", "B", "D", "l", "p", "c", "s"}));
  EXPECT_EQ(system.points(), 3U);
  EXPECT_EQ(system.describe(system.constraints[1]), "constraint 2, distance A l");  // in the order of sorts
  EXPECT_EQ(system.constraints[1].kind->sorts, (std::vector<Sort>{Sort::point, Sort::line}));
  const Figure& sketch = *system.sketch;
  EXPECT_EQ(sketch[3], (std::vector<double>{1, 0, 0, 0, 0, 1}));
  EXPECT_EQ(sketch[4], (std::vector<double>{0, 0.6, 0.8, 1.6}));
  EXPECT_EQ(sketch[5], (std::vector<double>{0, 1, 0, 0, 0, -1, 2}));
  EXPECT_EQ(sketch[6], (std::vector<double>{2, 0, 0, 1.5}));
  const std::vector<double> parameters = parameters_of(system, sketch);
  const std::vector<double> expected = {2, 1, 1.5, std::asin(0.8)};
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(parameters[i], expected[i], 1e-15);
}

TEST(Objects, OfThePlaneHaveNormalForms) {
  const ConstraintSystem system = read(
      "universe: 2d\npoints: [A, B]\nlines: [l, m]\ncircles: [c]\nconstraints:\n"
      "  - {distance: [A, B], parameter: h}\n"
      "valuations: {v: {h: 1}}\n"
      "sketch: {A: [0, 0], B: [1, 0], l: {through: [[1, 0], [1, 5]]}, m: {point: [0, 2], direction: [3, "
      "0]}, c: {centre: [1, 2], radius: 0}}\n");
  const Figure& sketch = *system.sketch;
  EXPECT_EQ(sketch[2], (std::vector<double>{-1, 0, -1}));  // x = 1
  EXPECT_EQ(sketch[3], (std::vector<double>{0, 1, 2}));    // y = 2
  EXPECT_EQ(sketch[4], (std::vector<double>{1, 2, 0}));
  const GeometricEquations equations = geometric_equations(system, {0, 1});
  EXPECT_EQ(equations.unknowns, (std::vector<std::string>{"B_x", "l_nx", "l_ny", "l_d", "m_nx", "m_ny", "m_d",
                                                          "c_x", "c_y", "c_r"}));
  EXPECT_EQ(equations.equations.size(), 3U);  // a distance, two normals
}

struct Mistake {
  std::string old, by;
  std::vector<std::string> words;
};

const std::vector<Mistake>& mistakes() {
  static const std::vector<Mistake> all = {
      {"[l, A]", "[ll, A]", {":9", "unknown object 'll'"}},
      {"[l, A]",
       "[s, A]",
       {":9", "constraint 2, distance s A", "a point and a line", "a point and a sphere"}},
      {"[l, A]", "[l, A, B]", {":9", "takes 2 points", "not 2 points and a line"}},
      {"radius: [s]", "radius: [p]", {":11", "radius p", "a circle", "a plane"}},
      {"[p, l]", "[p, p]", {":13", "plane 'p' twice"}},
      {"{incidence: [D, c]}", "{tangent: [l, c]}", {":10", "tangent l c", "is for the other universe"}},
      {"universe: 3d", "universe: 2d", {":4", "3d"}},
      {"planes: [p]", "planes: [l]", {":4", "line 'l' again"}},
      {"planes: [p]", "planes: [p, A]", {":4", "point 'A' again"}},
      {"a: 30 deg", "a: 100 deg", {":14", "constraint 6, angle l p", "impossible"}},
      {"r: 3", "r: -3", {":14", "constraint 4, radius s", "impossible"}},
      {"[[1, 0, 5], [1, 0, 9]]", "[[1, 0, 5], [1, 0, 5]]", {":19", "one place"}},
      {"[[1, 0, 5], [1, 0, 9]]", "[[1, 0, 5], [1, 0]]", {":19", "2 coordinates"}},
      {"[[1, 0, 5], [1, 0, 9]]", "[[1, 0, 5]]", {":19", "1 points; expected 2"}},
      {"{through: [[1, 0, 5], [1, 0, 9]]}", "{point: [1, 0, 5]}", {":19", "direction"}},
      {"{through: [[1, 0, 5], [1, 0, 9]]}", "[1, 0, 5]", {":19"}},
      {"{point: [0, 0, 2], normal: [0, 3, 4]}",
       "{through: [[0, 0, 1], [1, 0, 1], [3, 0, 1]]}",
       {":20", "on a line"}},
      {"normal: [0, 3, 4]", "normal: [0, 0, 0]", {":20", "no direction"}},
      {"normal: [0, 3, 4]", "norml: [0, 3, 4]", {":20", "norml"}},
      {"radius: 1.5", "radius: -1.5", {":22", "negative"}},
      {"radius: 1.5", "radius: 1.5, normal: [1, 0, 0]", {":22", "normal"}},
      {", normal: [0, 0, -7]", "", {":21", "normal"}},
      {"  p: {point: [0, 0, 2], normal: [0, 3, 4]}\n", "", {"'p'"}},
  };
  return all;
}

TEST(Objects, MistakesAreNamed) {
  for (const auto& [old, by, words] : mistakes()) {
    const std::string text = replaced(in_space() + drawn(), old, by);
    const std::string error = error_text([&] { static_cast<void>(read(text)); });
    for (const std::string& word : words)
      EXPECT_NE(error.find(word), std::string::npos) << by << ": " << error;
  }
  const std::string frame = error_text([] { static_cast<void>(read(in_space() + "frame: [A, B, l]\n")); });
  EXPECT_NE(frame.find("a frame is of points"), std::string::npos) << frame;
  EXPECT_NE(error_text([] { static_cast<void>(read("universe: 2d\nconstraints: []\n")); }).find("no object"),
            std::string::npos);
}

/// Figures on which the boolean constraints hold, in the frame: their unknowns satisfy the equations with the
/// parameters read before the move, and lie in the box for these parameters.
TEST(Objects, SatisfyTheirEquationsInTheFrameAndLieInTheBox) {
  const std::string text =
      "universe: 3d\npoints: [A, B, D]\nlines: [l, m]\nplanes: [p, q]\ncircles: [c]\nspheres: [s, t]\n"
      "constraints:\n"
      "  - {distance: [A, B], parameter: a}\n  - {distance: [B, D], parameter: b}\n"
      "  - {distance: [D, l], parameter: e}\n  - {distance: [A, p], parameter: f}\n"
      "  - {incidence: [l, q]}\n  - {angle: [m, p], parameter: g}\n  - {incidence: [B, m]}\n"
      "  - {incidence: [A, s]}\n  - {radius: [s], parameter: r}\n  - {radius: [t], parameter: k}\n"
      "  - {tangent: [s, t], interpretation: external}\n  - {centre: [D, c]}\n  - {parallel: [p, q]}\n"
      "valuations: {v: {a: 1, b: 1, e: 1, f: 1, g: 1, r: 1, k: 1}}\n";
  ConstraintSystem system = read(text);
  Random random(fuzz_seed(), "objects in a frame");
  std::size_t bounded = 0;
  for (std::size_t n = 0; n < fuzz_cases(50); ++n) {
    system.frame = Frame();
    const GeometricEquations free = geometric_equations(system, {});
    const FigureProjection figure =
        satisfy_common_equations(system, free, unknowns_of(free, random_figure(system, random)));
    if (!figure.holds) continue;
    const Figure original = figure_at(free, figure.unknowns);
    if (original[8].back() < 0 || original[9].back() < 0) continue;  // a radius is not negative
    const std::vector<double> parameters = parameters_of(system, original);
    const Frame frame = {n % 3, (n + 1) % 3, (n + 2) % 3};
    const GeometricEquations equations = geometric_equations(system, frame);
    std::vector<double> numbers =
        satisfy_common_equations(system, equations, unknowns_of(equations, in_frame(system, frame, original)))
            .unknowns;
    Valuation valuation{"read", {}};
    for (const double value : parameters)
      valuation.values.push_back(system.values_graph->constant(Rational(value)));
    const Box box = equation_system(equations, system, frame, valuation).box;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      ASSERT_GE(numbers[i], box[i].lower - 1e-9) << equations.unknowns[i];
      ASSERT_LE(numbers[i], box[i].upper + 1e-9) << equations.unknowns[i];
      bounded += is_bounded(box[i]) ? 1U : 0U;
    }
    numbers.insert(numbers.end(), parameters.begin(), parameters.end());
    for (const double value : values_at(equations, numbers)) ASSERT_NEAR(value, 0, 1e-9);
  }
  EXPECT_GT(bounded, 20 * fuzz_cases(50));
}

TEST(Objects, AreBoundedByWhatTheyTouch) {
  const ConstraintSystem system = read(
      "universe: 2d\npoints: [A, B, E]\nlines: [l, m]\ncircles: [c, d]\nconstraints:\n"
      "  - {distance: [A, B], parameter: h}\n  - {incidence: [B, l]}\n  - {incidence: [E, l]}\n  - "
      "{distance: [B, m], parameter: k}\n"
      "  - {centre: [B, c]}\n  - {radius: [c], parameter: r}\n  - {tangent: [c, d]}\n"
      "  - {radius: [d], parameter: s}\n"
      "valuations: {v: {h: 1, k: 2, r: 4, s: 8}}\n");
  const GeometricEquations equations = geometric_equations(system, {0, 1});
  const Box box = equation_system(equations, system, {0, 1}, system.valuation("")).box;
  constexpr double kFar = std::numeric_limits<double>::infinity();  // E may be anywhere on l
  const std::vector<double> upper = {1, kFar, kFar, 1, 1, 1, 1, 1, 3, 1, 1, 4, 13, 13, 8};
  ASSERT_EQ(box.size(), upper.size());
  for (std::size_t i = 0; i < upper.size(); ++i) {
    EXPECT_GE(box[i].upper, upper[i]) << equations.unknowns[i];
    EXPECT_LE(box[i].upper, upper[i] + 1e-14) << equations.unknowns[i];
  }
  EXPECT_EQ(box[11].lower, 0);  // a radius
  EXPECT_EQ(box[3].lower, -1);
}

TEST(Objects, DrawnAtRandomAreNormalised) {
  ConstraintSystem system = read(in_space());
  Random random(fuzz_seed(), "random objects");
  const GeometricEquations equations = geometric_equations(system, {});
  for (std::size_t n = 0; n < fuzz_cases(100); ++n) {
    std::vector<double> numbers = unknowns_of(equations, random_figure(system, random));
    numbers.resize(numbers.size() + system.parameters.size(), 0.0);
    const std::vector<double> values = values_at(equations, numbers);
    for (std::size_t k = 0; k < values.size(); ++k) {
      if (equations.constraint_of_equation[k]) continue;
      ASSERT_NEAR(values[k], 0, 1e-15);
    }
  }
}

}  // namespace
}  // namespace gcslab
