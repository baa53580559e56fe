// What the drawings of the task `illustrate` compute is what their sources print.

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "experiments/tasks/illustrate_task.h"
#include "experiments/tasks/job_result.h"

namespace gcslab {
namespace {

JobResult drawn(const std::string& problem, const std::string& method,
                const std::map<std::string, std::string>& options = {}) {
  const IllustrateTask task;
  Job job;
  job.task = "illustrate";
  job.problem = problem;
  job.method = method;
  job.options = Options(task.method(method).options, options, method);
  task.check(job);
  return task.run(job, {});
}

void expect_as_published(const Json& values, const std::string& name) {
  ASSERT_TRUE(values.contains(name) && values.contains("published_" + name)) << values.dump();
  const Json& value = values[name];
  EXPECT_EQ(value.is_string() ? value.get<std::string>() : value.dump(),
            values["published_" + name].get<std::string>());
}

TEST(Illustration, ReductionByLinearProgramsIsThePublishedOne) {
  const Json values = drawn("illustrations/parabola-and-line", "lp_reduction_steps").values;
  expect_as_published(values, "range");
  expect_as_published(values, "reduction");
  // The widths are about squared: 4 x^2 + x - 3 has a simple root.
  const auto widths = values["widths"].get<std::vector<std::string>>();
  ASSERT_GE(widths.size(), 3U);
  for (std::size_t i = 1; i < widths.size(); ++i)
    EXPECT_LT(std::stod(widths[i]), std::pow(std::stod(widths[i - 1]), 1.7));
}

TEST(Illustration, PolytopesAreThePublishedOnes) {
  const Json triangle =
      drawn("illustrations/parabola-and-line", "bernstein_polytope", {{"inequalities", "products"}}).values;
  expect_as_published(triangle, "vertices");
  expect_as_published(triangle, "half_spaces");
  const Json cube = drawn("illustrations/cube", "bernstein_simplex").values;
  expect_as_published(cube, "vertices");
  EXPECT_EQ(cube["volume"], "1/54");
  expect_as_published(
      drawn("illustrations/product", "bernstein_polytope", {{"inequalities", "products"}}).values,
      "half_spaces");
  expect_as_published(
      drawn("illustrations/two-unknowns", "bernstein_polytope", {{"inequalities", "published"}}).values,
      "half_spaces");
}

TEST(Illustration, TheCombinationHasThePublishedMultiplier) {
  expect_as_published(drawn("illustrations/equation-and-inequality", "positive_combination").values,
                      "multiplier");
}

/// The octahedron's path comes back, and crosses t = 1 at its four figures.
TEST(Illustration, TheGuidePathIsClosedAndHasTheFiguresOnIt) {
  const JobResult result = drawn("polyhedra/octahedron", "guide_path");
  EXPECT_EQ(result.values["crossings"], 4);
  EXPECT_EQ(result.values["branch_changes"].get<int>() % 2, 0);
  const Json shapes = result.artifact["panels"][0]["shapes"];
  std::vector<Json> arcs;
  for (const Json& shape : shapes) {
    if (shape["kind"] == "polyline") arcs.push_back(shape["points"]);
  }
  ASSERT_EQ(arcs.size(), result.values["branch_changes"].get<std::size_t>() + 1);
  for (std::size_t k = 1; k < arcs.size(); ++k) EXPECT_EQ(arcs[k].front(), arcs[k - 1].back());
  for (const std::size_t axis : {0U, 1U})
    EXPECT_NEAR(arcs.front().front()[axis].get<double>(), arcs.back().back()[axis].get<double>(), 2e-3);
}

/// The circles in which a plane through both places of a point cuts the spheres all pass through the point.
TEST(Illustration, TheSpheresAtAChangeOfBranchMeetInThePoint) {
  const Json panels = drawn("polyhedra/octahedron", "border_crossing", {{"change", "2"}, {"reach", "0.2"}})
                          .artifact["panels"];
  ASSERT_EQ(panels.size(), 4U);
  std::vector<double> heights;
  for (std::size_t k = 1; k < 4; ++k) {
    const Json shapes = panels[k]["shapes"];
    std::size_t circles = 0;
    for (const Json& shape : shapes) {
      if (shape["kind"] == "points") heights.push_back(shape["points"][0][1].get<double>());
    }
    ASSERT_EQ(heights.size(), k);
    for (const Json& shape : shapes) {
      if (shape["kind"] != "polyline") continue;
      ++circles;
      double low = HUGE_VAL, high = -HUGE_VAL;
      for (const Json& point : shape["points"]) {
        low = std::min(low, point[0].get<double>());
        high = std::max(high, point[0].get<double>());
      }
      EXPECT_NEAR(std::hypot((low + high) / 2, heights.back()), (high - low) / 2, 1e-9);
    }
    EXPECT_EQ(circles, 3U);
  }
  EXPECT_LT(heights[0] * heights[2], 0);  // on the other side after the change
  EXPECT_LT(std::abs(heights[1]), 0.2 * std::abs(heights[0]));
}

/// Every number of a drawing is finite, and every panel has shapes.
TEST(Illustration, DrawingsAreWhole) {
  const std::vector<std::pair<std::string, std::string>> drawings = {
      {"illustrations/parabola-and-line", "lp_reduction_steps"},
      {"illustrations/parabola-and-line", "bernstein_polytope"},
      {"illustrations/square", "bernstein_polytope"},
      {"illustrations/exponential", "bernstein_polytope"},
      {"illustrations/product", "bernstein_polytope"},
      {"illustrations/cube", "bernstein_polytope"},
      {"illustrations/biquadratic", "control_point_projection"},
      {"illustrations/two-lines", "preconditioning"},
      {"illustrations/two-curves", "preconditioning"},
      {"illustrations/equation-and-inequality", "positive_combination"},
      {"polyhedra/pentahedron", "branch_tree"},
      {"polyhedra/octahedron", "guide_path"},
      {"polyhedra/octahedron", "border_crossing"},
      {"polyhedra/octahedron", "simplices_across"}};
  for (const auto& [problem, method] : drawings) {
    const Json panels = drawn(problem, method).artifact["panels"];
    ASSERT_GE(panels.size(), 1U) << problem;
    for (const Json& panel : panels) {
      ASSERT_GE(panel["shapes"].size(), 2U) << problem;
      for (const Json& shape : panel["shapes"]) {
        for (const Json& point : shape["points"])
          ASSERT_TRUE(std::isfinite(point[0].get<double>()) && std::isfinite(point[1].get<double>()))
              << problem;
      }
    }
  }
}

TEST(Illustration, WhatDoesNotApplyIsSaid) {
  EXPECT_THROW(drawn("illustrations/exponential", "lp_reduction_steps"), NotApplicable);
  EXPECT_THROW(drawn("illustrations/product", "bernstein_simplex"), NotApplicable);
  EXPECT_THROW(drawn("illustrations/square", "preconditioning"), NotApplicable);
  EXPECT_THROW(drawn("polyhedra/icosahedron", "guide_path"), NotApplicable);  // three guides
  EXPECT_THROW(drawn("polyhedra/octahedron", "border_crossing", {{"change", "100"}}), NotApplicable);
  EXPECT_THROW(drawn("polyhedra/octahedron", "simplices_across", {{"change", "100"}, {"mesh", "0.005"}}),
               NotApplicable);
}

}  // namespace
}  // namespace gcslab
