// Blocks of plans with solutions at infinity, against Imbach 2013, section 4.2.2, and by hand.

#include "construction/plan_escapes.h"

#include <gtest/gtest.h>

#include "support/corpus_figure.h"

namespace gcslab {
namespace {

constexpr PlanKind kKinds[] = {PlanKind::forward, PlanKind::gao, PlanKind::least, PlanKind::henneberg};

Plan plan_of(const CorpusFigure& figure, PlanKind kind) {
  return make_plan(figure.system, kind, figure.random_sketch(1));
}

TEST(PlanEscapes, OfTheThesisExampleAreThoseOfP3) {
  const CorpusFigure figure = corpus_figure("polyhedra/6p7d3a2c");
  for (const PlanKind kind : kKinds) {
    const Plan plan = plan_of(figure, kind);
    const std::vector<PlanEscape> escapes = escapes_of(plan, figure.system);
    ASSERT_EQ(escapes.size(), 1U);
    EXPECT_EQ(figure.system.objects[escapes[0].point].name, "P3");
    // All distances that place it are guides.
    EXPECT_EQ(escapes[0].guides.size() + escapes[0].constraints.size(), 3U);
    for (const std::size_t guide : escapes[0].guides) EXPECT_EQ(plan.guides[guide].point, escapes[0].point);
  }
  const std::vector<PlanEscape> henneberg = escapes_of(plan_of(figure, PlanKind::henneberg), figure.system);
  EXPECT_EQ(henneberg[0].guides.size(), 3U);
  EXPECT_TRUE(henneberg[0].constraints.empty());
}

TEST(PlanEscapes, AreNoneWhereDistancesTieAllPoints) {
  for (const char* name :
       {"polyhedra/octahedron", "polyhedra/pentahedron", "molecules/disulfide-distances"}) {
    const CorpusFigure figure = corpus_figure(name);
    for (const PlanKind kind : kKinds)
      EXPECT_TRUE(escapes_of(plan_of(figure, kind), figure.system).empty()) << name;
  }
}

CorpusFigure figure_of(const std::string& constraints, const std::string& values) {
  CorpusFigure result{
      read_constraint_system(YamlNode::parse(
          "kind: constraint_system\nname: test\nuniverse: 2d\npoints: [A, B, C, D]\nconstraints:\n" +
              constraints + "valuations: {wanted: {" + values + "}}\norigin: test\nlicence: test\n",
          "test.yaml")),
      {},
      {}};
  result.frame = frame_of(result.system);
  result.equations = geometric_equations(result.system, result.frame);
  return result;
}

TEST(PlanEscapes, OfLinesAreWhereTheyAreParallel) {
  // D lies where two lines meet.
  const CorpusFigure figure = figure_of(
      "  - {distance: [A, B], parameter: a}\n  - {distance: [B, C], parameter: b}\n"
      "  - {distance: [A, C], parameter: c}\n  - {area: [A, B, D], parameter: d}\n"
      "  - {area: [B, C, D], parameter: e}\n",
      "a: 3, b: 4, c: 5, d: 1, e: 1");
  const std::optional<Plan> plan = plan_without_guides(figure.system, figure.frame);
  ASSERT_TRUE(plan.has_value());
  const std::vector<PlanEscape> escapes = escapes_of(*plan, figure.system);
  ASSERT_EQ(escapes.size(), 1U);
  EXPECT_TRUE(escapes[0].guides.empty());
  EXPECT_EQ(escapes[0].configuration,
            "D infinitely far: the loci of area A B D and area B C D do not meet in one point");
}

TEST(PlanEscapes, AreNoneWhereLaterPointsTieAPoint) {
  // C has no distance to A or B, but one to D, which has one to B.
  const CorpusFigure tied = figure_of(
      "  - {distance: [A, B], parameter: a}\n  - {area: [A, B, C], parameter: b}\n"
      "  - {angle: [A, B, C], parameter: c}\n  - {distance: [C, D], parameter: d}\n"
      "  - {distance: [B, D], parameter: e}\n",
      "a: 3, b: 4, c: 1, d: 1, e: 1");
  for (const PlanKind kind : {PlanKind::forward, PlanKind::gao, PlanKind::least})
    EXPECT_TRUE(escapes_of(plan_of(tied, kind), tied.system).empty());
}

TEST(PlanEscapes, AreMetByTheFirstPointThatIsFar) {
  const CorpusFigure figure = corpus_figure("polyhedra/6p7d3a2c");
  const Plan plan = plan_of(figure, PlanKind::least);
  const std::vector<PlanEscape> escapes = escapes_of(plan, figure.system);
  Figure far = *sketch_of(figure.system);
  EXPECT_EQ(escape_met(escapes, plan, figure.system, far, 100), "");
  far[3] = {100, 1e4, 0};
  EXPECT_EQ(escape_met(escapes, plan, figure.system, far, 100),
            escapes[0].configuration + "; angle P2 P3 P4 goes to 0 and angle P2 P3 P0 goes to 0");
  // Another point, which the plan does not let go there.
  far = *sketch_of(figure.system);
  far[1] = {1e4, 0, 0};
  EXPECT_EQ(escape_met(escapes, plan, figure.system, far, 100), "");
}

}  // namespace
}  // namespace gcslab
