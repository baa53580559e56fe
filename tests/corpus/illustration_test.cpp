// What the drawings of the task `illustrate` compute is what their sources print.

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
      {"illustrations/equation-and-inequality", "positive_combination"}};
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
}

}  // namespace
}  // namespace gcslab
