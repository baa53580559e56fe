// What a user sees of the methods that construct: figures, the plan as text, and why a method does not apply.

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <set>

#include "cli/gcslab_shell.h"

namespace gcslab {
namespace {

using Json = nlohmann::json;

class PlanMethods : public GcslabShell {
 protected:
  Json solved(const std::string& arguments, int exit_code = 0) {
    const Answer answer = shell("$gcslab solve " + arguments + " --json r.json");
    EXPECT_EQ(answer.exit_code, exit_code) << answer.err;
    return Json::parse(text_of(folder_ / "r.json"));
  }
};

TEST_F(PlanMethods, FindTheOctahedronsFigures) {
  for (const char* method :
       {"plan_path", "plan_path_adaptive", "plan_pli", "plan_sampling", "plan_exploration"}) {
    const Json result = solved(std::string("polyhedra/octahedron --method ") + method);
    EXPECT_EQ(result["classes"].size(), 4U) << method;
    EXPECT_EQ(result["completeness"], "none");
    EXPECT_EQ(result["plan"]["guides"], 1);
    EXPECT_EQ(result["plan"]["text"].size(), 8U);
    const Json solutions = result["solutions"];
    for (const Json& solution : solutions) EXPECT_EQ(solution["certificate"]["claim"], "unique") << method;
    EXPECT_EQ(shell("$gcslab verify r.json").exit_code, 0) << method;
  }
  EXPECT_GT(solved("polyhedra/octahedron --method plan_pli")["plan"]["branch_changes"], 0);
}

TEST_F(PlanMethods, ChangeThePlanWhereItBecomesSingular) {
  const std::string sketch = " --set random_sketch=4";
  const Json one = solved("polyhedra/pentahedron --method plan_path" + sketch, 3);
  EXPECT_TRUE(one["paths"][0].contains("plan_event"));
  const Json result = solved("polyhedra/pentahedron --method plan_path_adaptive" + sketch);
  const Json usual = solved("polyhedra/pentahedron --method sketch_path" + sketch);
  EXPECT_EQ(result["paths"][0]["type"], "cycle");
  EXPECT_EQ(result["classes"].size(), usual["classes"].size());
  EXPECT_GT(one["classes"].size(), 0U);
  EXPECT_LT(one["classes"].size(), usual["classes"].size());
  EXPECT_GT(result["plan"]["plans"], 1);
  EXPECT_GE(result["plan"]["plan_changes"], result["plan"]["plans"].get<int>() - 1);
}

/// What touches flat figures of a continuum of solutions is found once, on whichever side.
TEST_F(PlanMethods, ListEachFigureOfAContinuumOnceHoweverThePathComesThere) {
  const Json result = solved("polyhedra/hexahedron --method plan_path_adaptive");
  const Json usual = solved("polyhedra/hexahedron --method sketch_path");
  EXPECT_EQ(result["paths"][0]["type"], "cycle");
  EXPECT_EQ(result["classes"].size(), usual["classes"].size());
}

TEST_F(PlanMethods, ExploreFromThePentahedronsSketch) {
  const Json all = solved("polyhedra/pentahedron --method plan_exploration --set plan=henneberg");
  EXPECT_EQ(all["classes"].size(), 9U);
  EXPECT_GT(all["paths"].size(), 1U);
  const Json paths = all["paths"];
  for (const Json& path : paths) {
    const Json crossings = path["crossings"];
    for (const Json& crossing : crossings) EXPECT_LT(crossing["solution"], all["solutions"].size());
  }
  const Json one = solved("polyhedra/pentahedron --method plan_exploration --set maximum_paths=1", 3);
  EXPECT_EQ(one["paths"].size(), 1U);
  EXPECT_EQ(one["status"], "budget_exhausted");
}

/// Each step uses points of earlier steps alone, each guide once; what is told by names is the plan's text.
TEST_F(PlanMethods, TellTheStepsOfThePlan) {
  for (const char* kind : {"least", "henneberg", "gao", "forward"}) {
    const Json plan =
        solved("polyhedra/pentahedron --method plan_exploration --set maximum_paths=1 --set plan=" +
                   std::string(kind),
               3)["plan"];
    std::set<std::string> placed, guides;
    std::size_t choices = 0;
    for (const Json& step : plan["steps"]) {
      EXPECT_EQ(step["loci"].size(), std::min<std::size_t>(placed.size(), 3)) << kind;
      const auto text = plan["text"][placed.size()].get<std::string>();
      const std::string line = step["object"].get<std::string>() + " = ";
      for (const Json& locus : step["loci"]) {
        for (const Json& point : locus["of"]) EXPECT_TRUE(placed.contains(point)) << kind << point;
        const std::string value = locus.value("value", "");
        const bool is_guide = locus.value("guide", false);
        EXPECT_TRUE(!is_guide || guides.insert(value).second) << kind << ": " << value;
        if (locus["kind"] != "sphere") continue;
        const std::string sphere = "sphere(" + locus["of"][0].get<std::string>() + ", " + value + ")";
        EXPECT_NE(text.find(sphere), std::string::npos) << text;
      }
      EXPECT_EQ(text.rfind(line, 0), 0U) << text;
      choices += step["places"] == 2 ? 1U : 0U;
      placed.insert(step["object"]);
    }
    EXPECT_EQ(placed.size(), 6U);
    EXPECT_EQ(guides.size(), plan["guides"]) << kind;
    EXPECT_EQ(choices, plan["choices"]) << kind;
    EXPECT_EQ(plan["removed_constraints"].size(), plan["removed"]) << kind;
  }
}

TEST_F(PlanMethods, SayWhyTheyDoNotApply) {
  const auto expect = [&](const std::string& arguments, const std::string& text) {
    const Answer answer = shell("$gcslab solve " + arguments);
    EXPECT_EQ(answer.exit_code, 4) << arguments;
    EXPECT_NE(answer.err.find(text), std::string::npos) << answer.err;
  };
  expect("sketches/apollonius --method plan_path", "construction plans place points");
  expect("polyhedra/octahedron-equations --method plan_exploration", "only constraint systems have a sketch");
  expect("polyhedra/pentahedron --method plan_sampling", "one guide parameter is sampled");
  expect("polyhedra/hexahedron-flat --method plan_path", "under-constrained");
}

}  // namespace
}  // namespace gcslab
