// Plans evaluated in numbers: distances to the border, 256 bits against doubles, and the way from a figure to
// values and back.

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <iostream>

#include "base/random.h"
#include "construction/plan_border.h"
#include "construction/plan_enclosure.h"
#include "construction/plan_singularity.h"
#include "support/corpus_figure.h"
#include "support/fuzz.h"

namespace gcslab {
namespace {

constexpr PlanKind kKinds[] = {PlanKind::forward, PlanKind::gao, PlanKind::least, PlanKind::henneberg};
constexpr double kEpsilon = 0x1p-52;

const char* const kPointProblems[] = {"polyhedra/octahedron",       "polyhedra/pentahedron",
                                      "polyhedra/hexahedron",       "polyhedra/icosahedron",
                                      "polyhedra/6p7d3a2c",         "molecules/disulfide-distances",
                                      "kinematics/planar-platform", "sketches/triangle"};

/// A plan with the values and the branch of a random figure.
struct Read {
  Read(const CorpusFigure& corpus, PlanKind kind, std::uint64_t seed)
      : drawn(figure_at(corpus.equations,
                        unknowns_of(corpus.equations,
                                    in_frame(corpus.system, corpus.frame, corpus.random_sketch(seed))))),
        program(corpus.system, make_plan(corpus.system, kind, drawn)),
        evaluator(program),
        figure(in_frame(corpus.system, program.plan(), drawn)),
        values(evaluator.read(figure, parameters_of(corpus.system, drawn))),
        branch(evaluator.branch(values)) {}

  Figure drawn;
  PlanProgram program;
  PlanEvaluator evaluator;
  Figure figure;
  PlanValues values;
  Branch branch;
};

TEST(PlanNumbers, OfAFigureComeBack) {
  const std::uint64_t seed = fuzz_seed();
  for (const char* name : kPointProblems) {
    const CorpusFigure corpus = corpus_figure(name);
    for (const PlanKind kind : kKinds) {
      for (std::uint64_t k = 0; k < 5; ++k) {
        Read of(corpus, kind, seed + k);
        const PlanPlace place = of.evaluator.evaluate(of.values, of.branch);
        ASSERT_EQ(place.failure, PlanFailure::none) << name << " seed " << seed + k;
        const PlanValues again = of.evaluator.read(place.figure, of.values.parameters);
        for (std::size_t g = 0; g < again.guides.size(); ++g)
          EXPECT_NEAR(again.guides[g], of.values.guides[g], 1e-6) << name << " seed " << seed + k;
        for (std::size_t c = 0; c < again.heights.size(); ++c) {
          EXPECT_NEAR(again.heights[c], of.values.heights[c], 1e-5) << name << " seed " << seed + k;
          if (std::abs(again.heights[c]) > 1e-5) {
            EXPECT_EQ(of.evaluator.branch(again)[c], of.branch[c]);
          }
        }
      }
    }
  }
}

TEST(PlanNumbers, AgreeInDoublesAndIn256Bits) {
  const std::uint64_t seed = fuzz_seed();
  std::size_t compared = 0;
  for (const char* name : kPointProblems) {
    const CorpusFigure corpus = corpus_figure(name);
    for (const PlanKind kind : kKinds) {
      for (std::uint64_t k = 0; k < 3; ++k) {
        Read of(corpus, kind, seed + k);
        const auto border = border_of(of.program, of.values, of.branch);
        if (!border || border->least_radicand < 1e-2) continue;  // where rounding is not magnified much
        const auto enclosed = enclosed_figure(of.program, of.values, of.branch, 256);
        ASSERT_TRUE(enclosed.has_value()) << name << " seed " << seed + k;
        const PlanPlace place = of.evaluator.evaluate(of.values, of.branch);
        ++compared;
        for (std::size_t p = 0; p < enclosed->size(); ++p) {
          for (std::size_t i = 0; i < (*enclosed)[p].size(); ++i) {
            const Interval x = (*enclosed)[p][i].interval();
            EXPECT_LE(width(x), 2 * kEpsilon * std::max(1.0, magnitude(x)));
            EXPECT_NEAR(place.figure[p][i], midpoint(x), 1e-9) << name << " seed " << seed + k;
          }
        }
      }
    }
  }
  EXPECT_GT(compared, 10U);
}

/// Two circles of radii 1 to 3 that touch but for 10^-1 to 10^-13 of that. The height is as exact as the
/// radii say: rounding them moves h^2 by a few units in the last place of the largest square.
TEST(PlanNumbers, OfLociThatNearlyTouchAreAsExactAsTheirValues) {
  const CorpusFigure triangle = corpus_figure("sketches/triangle");
  const PlanProgram program(triangle.system,
                            make_plan(triangle.system, PlanKind::least, *sketch_of(triangle.system)));
  ASSERT_EQ(program.plan().choices(), 1U);
  PlanEvaluator evaluator(program);
  Random random(fuzz_seed(), "touching");
  double worst = 0, worst_along = 0;
  for (std::size_t k = 0; k < fuzz_cases(2000); ++k) {
    const double r = random.uniform(1, 3), s = random.uniform(1, 3);
    const double gap = std::pow(10, random.uniform(-13, -1));
    // A side is the sum or the difference of the others, nearly.
    PlanValues values{{r, s, (k % 2 == 0 ? (r + s) * (1 - gap) : std::abs(r - s) + gap)}, {}, {}, {}};
    std::rotate(values.parameters.begin(), values.parameters.begin() + static_cast<std::ptrdiff_t>(k % 3),
                values.parameters.end());
    const auto enclosed = enclosed_figure(program, values, {false}, 256);
    const PlanPlace place = evaluator.evaluate(values, {false});
    if (!enclosed || place.failure != PlanFailure::none) continue;
    const std::size_t last = program.plan().steps.back().point;
    const double size = *std::ranges::max_element(values.parameters);
    const double least = *std::ranges::min_element(values.parameters);
    const double height = std::abs(midpoint((*enclosed)[last][1].interval()));
    const double error = std::abs(place.figure[last][1] - midpoint((*enclosed)[last][1].interval()));
    const double along = std::abs(place.figure[last][0] - midpoint((*enclosed)[last][0].interval()));
    // The foot of the height is (r^2 - s^2 + c^2) / 2c, which small c magnify.
    const double foot_error = kEpsilon * size * size / least;
    worst_along = std::max(worst_along, along / foot_error);
    worst = std::max(worst, error * std::max(height, error) / (foot_error * size));
  }
  std::cout << "largest error: " << worst << " of what the rounding of the values explains; along the axis "
            << worst_along << "\n";
  EXPECT_LT(worst, 8);
  EXPECT_LT(worst_along, 8);
  EXPECT_GT(worst, 1e-3);  // the cases do come near to it
}

ConstraintSystem tetrahedron() {
  return read_constraint_system(YamlNode::parse(
      "kind: constraint_system\nname: test\nuniverse: 3d\npoints: [A, B, C, D]\nconstraints:\n"
      "  - {distance: [A, B], parameter: a}\n  - {distance: [A, C], parameter: b}\n"
      "  - {distance: [B, C], parameter: c}\n  - {distance: [A, D], parameter: d}\n"
      "  - {distance: [B, D], parameter: e}\n  - {distance: [C, D], parameter: f}\n"
      "valuations: {wanted: {a: 1, b: 1, c: 1, d: 1, e: 1, f: 1}}\norigin: test\nlicence: test\n",
      "test.yaml"));
}

/// The apex of a tetrahedron over a triangle of good shape, 10^-1 to 10^-7 above it.
TEST(PlanNumbers, OfSpheresThatNearlyTouchALineAreAsExactAsTheirValues) {
  const ConstraintSystem system = tetrahedron();
  const PlanProgram program(system, *plan_without_guides(system, frame_of(system)));
  PlanEvaluator evaluator(program);
  Random random(fuzz_seed(), "apex");
  double worst = 0;
  std::size_t compared = 0;
  for (std::size_t k = 0; k < fuzz_cases(1000); ++k) {
    const double height = std::pow(10, random.uniform(-7, -1));
    const Figure figure = {{0, 0, 0},
                           {random.uniform(2, 3), 0, 0},
                           {random.uniform(0.5, 1.5), random.uniform(2, 3), 0},
                           {random.uniform(-1, 3), random.uniform(-1, 3), height}};
    const PlanValues values{parameters_of(system, figure), {}, {}, {}};
    const Branch branch(program.plan().choices(), false);
    const auto enclosed = enclosed_figure(program, values, branch, 256);
    const PlanPlace place = evaluator.evaluate(values, branch);
    if (!enclosed || place.failure != PlanFailure::none) continue;  // rounded away
    ++compared;
    const std::size_t last = program.plan().steps.back().point;
    const double exact = midpoint((*enclosed)[last][2].interval());
    const double error = std::abs(place.figure[last][2] - exact);
    const double size = *std::ranges::max_element(values.parameters);
    worst = std::max(worst, error * std::max(std::abs(exact), error) / (kEpsilon * size * size));
  }
  std::cout << "largest error: " << worst << " of what the rounding of the values explains\n";
  EXPECT_GT(compared, 100U);
  EXPECT_LT(worst, 32);
  EXPECT_GT(worst, 1e-2);
}

TEST(PlanBorder, IsWhereTheDomainEnds) {
  const CorpusFigure octahedron = corpus_figure("polyhedra/octahedron");
  for (std::uint64_t k = 0; k < 5; ++k) {
    Read of(octahedron, PlanKind::least, fuzz_seed() + k);
    ASSERT_EQ(of.values.guides.size(), 1U);
    const auto is_inside = [&](double guide) {
      PlanValues there = of.values;
      there.guides[0] = guide;
      return border_of(of.program, there, of.branch).has_value();
    };
    double inside = of.values.guides[0], outside = inside + 100;
    ASSERT_TRUE(is_inside(inside));
    ASSERT_FALSE(is_inside(outside));
    for (int halving = 0; halving < 100; ++halving) {
      const double middle = (inside + outside) / 2;
      (is_inside(middle) ? inside : outside) = middle;
    }
    const double step = 1e-5;
    PlanValues near = of.values;
    near.guides[0] = inside - step;
    const auto border = border_of(of.program, near, of.branch);
    ASSERT_TRUE(border.has_value());
    EXPECT_NEAR(border->distance, step, 0.02 * step) << "seed " << fuzz_seed() + k;
    EXPECT_EQ(border->nearest_choice, border->least_choice);
    EXPECT_GT(border->least_radicand, 0);
    EXPECT_LT(border->least_radicand, 1e-3);
  }
}

TEST(PlanSingularity, IsWhereCentresComeOnALine) {
  const ConstraintSystem system = tetrahedron();
  const PlanProgram program(system, *plan_without_guides(system, frame_of(system)));
  for (const double angle : {1.5, 0.1, 1e-4, 0.0}) {
    // The first three points of the plan span that angle.
    Figure figure(4);
    const double places[4][3] = {
        {0, 0, 0}, {2, 0, 0}, {3 * std::cos(angle), 3 * std::sin(angle), 0}, {1, 1, 1}};
    for (std::size_t k = 0; k < 4; ++k)
      figure[program.plan().steps[k].point] = {places[k][0], places[k][1], places[k][2]};
    const auto least = least_general_step(program, figure, std::vector<double>(6, 1.0));
    ASSERT_TRUE(least.has_value());
    EXPECT_EQ(least->step, 3U);
    // The planes of the spheres are orthogonal to sides of the triangle.
    const double side = std::hypot(places[2][0] - 2, places[2][1]);
    const double sines[3] = {std::sin(angle), 3 * std::sin(angle) / side, 2 * std::sin(angle) / side};
    EXPECT_TRUE(
        std::ranges::any_of(sines, [&](double sine) { return std::abs(sine - least->sine) < 1e-12; }));
  }
}

TEST(PlanBorder, IsInfinitelyFarWithoutGuides) {
  Read of(corpus_figure("sketches/triangle"), PlanKind::least, fuzz_seed());
  const auto border = border_of(of.program, of.values, of.branch);
  ASSERT_TRUE(border.has_value());
  EXPECT_EQ(border->distance, HUGE_VAL);
  // Twice the area over the longest side is the height.
  const double height = of.values.heights[0];
  const double size = *std::ranges::max_element(of.values.parameters);
  EXPECT_NEAR(border->least_radicand, height * height / (size * size), 1e-12);
}

}  // namespace
}  // namespace gcslab
