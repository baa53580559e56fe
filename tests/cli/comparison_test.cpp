// What a user does to compare solvers with each other and with figures of other programs.

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <string>

#include "cli/gcslab_shell.h"

namespace gcslab {
namespace {

class Comparison : public GcslabShell {
 protected:
  void SetUp() override {
    GcslabShell::SetUp();
    write("other.yaml", R"yaml(kind: reference_table
name: other
title: Figures of another program
origin: "made up for a test"
licence: none
methods: {a: "Other 1.0"}
rows:
  - problem: separation/three-close-roots
    runs: {a: {status: complete, cpu_s: 100, boxes: 7, solutions: 3}}
  - problem: conics/ellipses-four
    runs: {a: {status: budget_exhausted, cpu_s: 60}}
)yaml");
    write("contest.yaml", R"yaml(experiment: contest
title: A contest
task: solve
problems: [separation/three-close-roots, conics/ellipses-four]
methods:
  - {name: adaptive}
  - {name: hull_newton}
  - {name: lp_reduction, label: careless, options: {lp_safety: unprotected}}
report:
  - table: {file: summary, kind: summary, references: other.yaml}
  - table: {file: against, kind: against, references: "other.yaml:a", filter: {method: adaptive}}
  - table: {file: time, rows: problem, columns: method, values: [cpu_s, boxes], references: other.yaml, best: min}
  - figure: {file: profile, kind: performance_profile, values: [cpu_s, boxes]}
)yaml");
  }
};

TEST_F(Comparison, TablesAndProfileSetMethodsBesideAnotherProgram) {
  const Answer run = shell("$gcslab run contest.yaml");
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const Answer report = shell("$gcslab report contest.yaml --reference none");
  ASSERT_EQ(report.exit_code, 0) << report.err;
  const fs::path reports = folder_ / "build/reports/contest";
  const std::string summary = text_of(reports / "summary.md");
  EXPECT_TRUE(has(summary, "| adaptive | 2 | 2 | 0 | 0 | 0 | 0 | 0 |")) << summary;
  EXPECT_TRUE(has(summary, "| Other 1.0 (not the same run) | 2 | 1 | 0 | 1 |")) << summary;
  EXPECT_TRUE(has(summary, "baselines, which are not rigorous, take no part (careless)")) << summary;
  const std::string against = text_of(reports / "against.md");
  EXPECT_TRUE(has(against, "Solved there and not by adaptive: none.")) << against;
  EXPECT_TRUE(has(against, "Solved by adaptive and not there: ellipses-four.")) << against;
  EXPECT_TRUE(has(text_of(reports / "time.md"), "Other 1.0 (not the same run)"));
  EXPECT_TRUE(has(text_of(reports / "profile.svg"), "</svg>"));
}

TEST_F(Comparison, ReferenceTablesAreListedDescribedAndChecked) {
  const Answer list = shell("$gcslab list problems --kind reference_table");
  EXPECT_EQ(list.exit_code, 0) << list.err;
  EXPECT_TRUE(has(list.out, "references/ibex-2.9")) << list.out;
  const Answer described = shell("$gcslab describe references/ibex-2.9 --json");
  ASSERT_EQ(described.exit_code, 0) << described.err;
  const auto json = nlohmann::json::parse(described.out);
  EXPECT_TRUE(has(json.at("origin"), "ibexsolve"));
  EXPECT_EQ(json.at("methods").size(), 2u);
  const Answer good = shell("$gcslab validate other.yaml");
  EXPECT_EQ(good.exit_code, 0) << good.err;
  EXPECT_TRUE(has(good.out, "reference table of 2 runs")) << good.out;
  write("bad.yaml",
        "kind: reference_table\nname: bad\ntitle: t\norigin: o\nlicence: l\nmethods: {a: A}\nrows:\n"
        "  - problem: kinematics/kin1\n    runs: {a: {status: done, cpu_s: 1}}\n");
  const Answer bad = shell("$gcslab validate bad.yaml");
  EXPECT_EQ(bad.exit_code, 1);
  EXPECT_TRUE(has(bad.err, "bad.yaml:9")) << bad.err;
  EXPECT_EQ(shell("$gcslab solve references/ibex-2.9").exit_code, 2);
}

TEST_F(Comparison, MisspeltReferencesAreRefusedBeforeAnyJob) {
  write("misspelt.yaml",
        "experiment: e\ntask: solve\nproblems: kinematics/kin1\nmethods: {name: adaptive}\nreport:\n"
        "  - table: {file: t, kind: against, references: ibex-2.8}\n");
  const Answer answer = shell("$gcslab run misspelt.yaml");
  EXPECT_EQ(answer.exit_code, 2);
  EXPECT_TRUE(has(answer.err, "misspelt.yaml:6")) << answer.err;
  EXPECT_EQ(lines(answer.err), 1u) << answer.err;
}

TEST_F(Comparison, OneReductionIsMeasuredAsTheUnknownsGrow) {
  write("growth.yaml", R"yaml(experiment: growth
task: reduction
problems: families/sparse-quadratic
methods: [{name: bernstein_projection}, {name: lp_reduction}]
parameters: {unknowns: [3, 50]}
report:
  - table: {file: sizes, rows: unknowns, columns: method, values: [tensor_coefficients, monomials, keeps_root]}
)yaml");
  ASSERT_EQ(shell("$gcslab run growth.yaml").exit_code, 0);
  const Answer report = shell("$gcslab report growth.yaml --reference none");
  ASSERT_EQ(report.exit_code, 0) << report.err;
  const std::string table = text_of(folder_ / "build/reports/growth/sizes.md");
  EXPECT_TRUE(has(table, "| 3 | 81 | 81 |")) << table;
  EXPECT_TRUE(has(table, "| 3 | 1 | 1 |")) << "both keep the root\n" << table;
  EXPECT_TRUE(has(table, "35894899384592629438512450 coefficients, more than 1048576")) << table;
}

}  // namespace
}  // namespace gcslab
