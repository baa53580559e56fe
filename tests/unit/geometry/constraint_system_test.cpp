// Constraint systems from text to equations: what is read, what is refused and how the message names it, the
// frame, and figures that satisfy the equations of the parameters that they show.

#include <cmath>
#include <gtest/gtest.h>

#include "base/random.h"
#include "expression/tape_evaluator.h"
#include "geometry/constraint_system_reader.h"
#include "geometry/geometric_equations.h"
#include "geometry/sketch.h"
#include "support/error_text.h"
#include "support/fuzz.h"

namespace gcslab {
namespace {

/// A tetrahedron with a fifth point in the plane of a face.
std::string tetrahedron() {
  return "universe: 3d\n"
         "points: [A, B, C, D, E]\n"
         "constraints:\n"
         "  - {distance: [A, B], parameter: h0}\n"
         "  - {distance: [B, C], parameter: h1}\n"
         "  - {distance: [A, C], parameter: h1}\n"
         "  - {distance: [A, D], parameter: h2, interpretation: norm}\n"
         "  - {distance: [B, D], parameter: h3}\n"
         "  - {angle: [C, A, D], parameter: a}\n"
         "  - {coplanar: [A, E, B, C]}\n"
         "  - {distance: [E, A], parameter: h4}\n"
         "  - {distance: [E, B], parameter: h4}\n"
         "valuations:\n"
         "  wanted: {h0: 1, h1: 1.5, h2: sqrt(2), h3: 2, h4: 1, a: 60 deg}\n"
         "  other: {h0: 1, h1: 1, h2: 1, h3: 1, h4: 1, a: pi/3}\n";
}

ConstraintSystem read(const std::string& text) {
  return read_constraint_system(YamlNode::parse(text, "figure.yaml"));
}

std::string replaced(std::string text, const std::string& old, const std::string& by) {
  const std::size_t place = text.find(old);
  EXPECT_NE(place, std::string::npos) << old;
  return text.replace(place, old.size(), by);
}

TEST(ConstraintSystemReader, ReadsAllThatIsSaid) {
  const ConstraintSystem system = read(tetrahedron() + "frame: [B, A, D]\nsketch: {random: 7}\n");
  EXPECT_EQ(system.universe, Universe::space);
  EXPECT_EQ(system.points(), 5U);
  EXPECT_EQ(system.constraints.size(), 9U);
  EXPECT_EQ(system.parameters, (std::vector<std::string>{"h0", "h1", "h2", "h3", "a", "h4"}));
  EXPECT_EQ(system.constraints[1].parameter, system.constraints[2].parameter);
  EXPECT_EQ(system.constraints[3].interpretation, 1U);
  EXPECT_EQ(system.describe(system.constraints[5]), "constraint 6, angle C A D");
  EXPECT_EQ(system.valuations.size(), 2U);
  EXPECT_EQ(system.valuation("").name, "wanted");
  EXPECT_EQ(system.valuation("other").name, "other");
  EXPECT_EQ(system.frame, (Frame{1, 0, 3}));
  EXPECT_EQ(system.random_sketch, 7U);
}

struct Mistake {
  std::string old, by;
  std::vector<std::string> words;  ///< that the message has
};

const std::vector<Mistake>& mistakes() {
  static const std::vector<Mistake> all = {
      {"universe: 3d", "universe: 4d", {"figure.yaml:1", "4d", "2d or 3d"}},
      {"[A, B, C, D, E]", "[A, B, C, D, A]", {"figure.yaml:2", "A"}},
      {"{distance: [A, B], parameter: h0}",
       "{distanze: [A, B], parameter: h0}",
       {":4", "distanze", "distance"}},
      {"{distance: [A, B], parameter: h0}", "{distance: [A, F], parameter: h0}", {":4", "'F'"}},
      {"{distance: [A, B], parameter: h0}", "{distance: [A, A], parameter: h0}", {":4", "twice"}},
      {"{distance: [A, B], parameter: h0}",
       "{distance: [A, B]}",
       {":4", "constraint 1, distance A B", "parameter"}},
      {"{distance: [A, B], parameter: h0}",
       "{distance: [A, B, C], parameter: h0}",
       {":4", "constraint 1, distance A B C", "2 points"}},
      {"{distance: [A, B], parameter: h0}",
       "{distance: [A, B], coplanar: [A, B, C, D], parameter: h0}",
       {":4", "second constraint"}},
      {"{distance: [A, B], parameter: h0}", "{parameter: h0}", {":4", "is no constraint"}},
      {"interpretation: norm", "interpretation: nrom", {":7", "nrom", "norm"}},
      {"{coplanar: [A, E, B, C]}", "{coplanar: [A, E, B, C], parameter: v}", {":10", "has no parameter"}},
      {"h0: 1, h1: 1.5", "h0: -1, h1: 1.5", {":14", "constraint 1, distance A B", "h0 = -1"}},
      {"a: 60 deg", "a: 200 deg", {"constraint 6, angle C A D", "200 deg", "impossible"}},
      {"h0: 1, h1: 1.5", "h1: 1.5", {":14", "h0"}},
      {"h0: 1, h1: 1.5", "h0: 1, h9: 1.5", {":14", "h9"}},
      {"h0: 1, h1: 1.5", "h0: sqrt(0-1), h1: 1.5", {":14", "not defined"}},
      {"h0: 1, h1: 1.5", "h0: banana, h1: 1.5", {":14", "banana"}},
  };
  return all;
}

TEST(ConstraintSystemReader, NamesWhatIsWrong) {
  for (const auto& [old, by, words] : mistakes()) {
    const std::string text = replaced(tetrahedron(), old, by);
    const std::string error = error_text([&] { static_cast<void>(read(text)); });
    for (const std::string& word : words)
      EXPECT_NE(error.find(word), std::string::npos) << by << ": " << error;
  }
  for (const std::string more :
       {"frame: [A, B]\n", "frame: [A, B, F]\n", "sketch: {A: [0, 0, 0]}\n", "sketch: {random: -1}\n",
        "sketch: {A: [0, 0], B: [0, 0, 0], C: [0, 0, 0], D: [0, 0, 0], E: [0, 0, 0]}\n"}) {
    const std::string error = error_text([&] { static_cast<void>(read(tetrahedron() + more)); });
    EXPECT_NE(error.find("figure.yaml:1"), std::string::npos) << more << error;
  }
  EXPECT_NE(error_text([] { static_cast<void>(read(tetrahedron()).valuation("wnted")); }).find("wanted"),
            std::string::npos);
}

TEST(Frame, AbsorbsWhatItCan) {
  const ConstraintSystem system = read(tetrahedron());
  const Frame frame = frame_of(system);
  EXPECT_EQ(frame, (Frame{0, 1, 2}));  // three distances; A B E absorbs the coplanarity too, with as many
  const FramedCoordinates framed = framed_coordinates(system, frame);
  EXPECT_TRUE(framed.is_absorbed[6]);
  EXPECT_TRUE(framed.is_zero[4][2]);
  EXPECT_FALSE(framed.is_zero[4][1]);
  EXPECT_FALSE(framed.is_zero[3][2]);
  const GeometricEquations equations = geometric_equations(system, frame);
  EXPECT_EQ(equations.unknowns,
            (std::vector<std::string>{"B_x", "C_x", "C_y", "D_x", "D_y", "D_z", "E_x", "E_y"}));
  EXPECT_EQ(equations.equations.size(), 8U);
}

TEST(Frame, OfThePlaneAbsorbsCollinearPoints) {
  const ConstraintSystem system = read(
      "universe: 2d\npoints: [A, B, C]\nconstraints:\n  - {distance: [A, B], parameter: h}\n  - {collinear: "
      "[C, "
      "A, B]}\n  - {distance: [A, C], parameter: h}\nvaluations: {v: {h: 1}}\n");
  const GeometricEquations equations = geometric_equations(system, frame_of(system));
  EXPECT_EQ(equations.unknowns.size(), 2U);
  EXPECT_EQ(equations.equations.size(), 2U);
}

TEST(Frame, NeedsPoints) {
  const std::string text =
      "universe: 3d\npoints: [A, B]\nconstraints:\n  - {distance: [A, B], parameter: h}\nvaluations: {v: {h: "
      "1}}\n";
  EXPECT_NE(error_text([&] { static_cast<void>(frame_of(read(text))); }).find("frame: none"),
            std::string::npos);
  EXPECT_TRUE(frame_of(read(text + "frame: none\n")).empty());
}

/// A random figure of which E lies in the plane of A, B and C.
Figure tetrahedron_and_point(Random& random) {
  Figure figure(5, std::vector<double>(3));
  for (auto& point : figure) {
    for (double& x : point) x = random.uniform(-1, 1);
  }
  const double s = random.uniform(-1, 1), t = random.uniform(-1, 1);
  for (std::size_t axis = 0; axis < 3; ++axis)
    figure[4][axis] = (1 - s - t) * figure[0][axis] + s * figure[1][axis] + t * figure[2][axis];
  return figure;
}

/// Parameters are read before the figure is moved into the frame, where its equations hold with them.
TEST(Sketch, SatisfiesTheEquationsOfItsParametersInTheFrame) {
  const ConstraintSystem system = read(
      "universe: 3d\npoints: [A, B, C, D, E]\nconstraints:\n"
      "  - {distance: [A, B], parameter: h0}\n  - {distance: [B, C], parameter: h1}\n"
      "  - {area: [A, C, D], parameter: s}\n  - {angle: [C, A, D], parameter: a}\n"
      "  - {coplanar: [A, E, B, C]}\n  - {distance: [E, D], parameter: h2, interpretation: norm}\n"
      "valuations: {v: {h0: 1, h1: 1, s: 1, a: 1, h2: 1}}\n");
  Random random(fuzz_seed(), "sketch equations");
  for (std::size_t n = 0; n < fuzz_cases(100); ++n) {
    const Figure figure = tetrahedron_and_point(random);
    const std::vector<double> parameters = parameters_of(system, figure);
    for (const Frame& frame : {Frame{0, 1, 2}, Frame{2, 0, 1}, Frame{3, 4, 0}}) {
      const Figure moved = in_frame(system, frame, figure);
      const GeometricEquations equations = geometric_equations(system, frame);
      std::vector<double> numbers;
      for (std::size_t p = 0; p < moved.size(); ++p) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
          if (!equations.objects[p][axis].is_constant()) numbers.push_back(moved[p][axis]);
        }
      }
      ASSERT_EQ(numbers.size(), equations.unknowns.size());
      ASSERT_EQ(figure_at(equations, numbers).size(), 5U);
      numbers.insert(numbers.end(), parameters.begin(), parameters.end());
      const Tape tape(equations.equations, static_cast<int>(numbers.size()));
      TapeEvaluator<double> evaluator(tape);
      evaluator.evaluate(numbers);
      for (std::size_t k = 0; k < equations.equations.size(); ++k) ASSERT_NEAR(evaluator.value(k), 0, 1e-12);
    }
  }
}

TEST(Sketch, KeepsDistancesInTheFrame) {
  const ConstraintSystem system = read(tetrahedron());
  Random random(fuzz_seed(), "sketch in frame");
  for (std::size_t n = 0; n < fuzz_cases(200); ++n) {
    const Figure figure = tetrahedron_and_point(random);
    const Frame frame = {n % 5, (n + 1) % 5, (n + 2 + n / 5 % 3) % 5};
    const Figure moved = in_frame(system, frame, figure);
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t axis = k; axis < 3; ++axis) ASSERT_EQ(moved[frame[k]][axis], 0);
    }
    EXPECT_GE(moved[frame[1]][0], 0);
    EXPECT_GE(moved[frame[2]][1], 0);
    for (std::size_t p = 0; p < 5; ++p) {
      for (std::size_t q = 0; q < p; ++q) {
        double before = 0, after = 0;
        for (std::size_t axis = 0; axis < 3; ++axis) {
          before += std::pow(figure[p][axis] - figure[q][axis], 2);
          after += std::pow(moved[p][axis] - moved[q][axis], 2);
        }
        ASSERT_NEAR(before, after, 1e-13);
      }
    }
  }
}

TEST(Sketch, RefusesWhatHasNoFrameOrNoAngle) {
  const ConstraintSystem system = read(tetrahedron());
  const Figure on_a_line = {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {0, 0, 1}, {0, 1, 0}};
  EXPECT_NE(error_text([&] {
              static_cast<void>(in_frame(system, {0, 1, 2}, on_a_line));
            }).find("A B C"),
            std::string::npos);
  const Figure at_one_place = {{0, 0, 0}, {0, 0, 0}, {2, 2, 2}, {0, 0, 0}, {0, 1, 0}};
  EXPECT_NE(error_text([&] {
              static_cast<void>(in_frame(system, {0, 1, 2}, at_one_place));
            }).find("one place"),
            std::string::npos);
  EXPECT_NE(error_text([&] { static_cast<void>(parameters_of(system, at_one_place)); }).find("angle C A D"),
            std::string::npos);
}

TEST(EquationSystem, BoundsWhatDistancesTieToTheOrigin) {
  const ConstraintSystem system = read(tetrahedron());
  const Frame frame = frame_of(system);
  const GeometricEquations equations = geometric_equations(system, frame);
  const EquationSystem square = equation_system(equations, system, frame, system.valuation("wanted"));
  ASSERT_EQ(square.box.size(), 8U);
  EXPECT_NEAR(square.box[0].upper, 1, 1e-15);             // B
  EXPECT_NEAR(square.box[1].upper, 1.5, 1e-15);           // C
  EXPECT_NEAR(square.box[3].upper, std::sqrt(2), 1e-15);  // D
  EXPECT_GE(square.box[3].upper, std::sqrt(2));
}

}  // namespace
}  // namespace gcslab
