// What a user does with gcslab, and what the program answers.

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <string>

#include "cli/gcslab_shell.h"

namespace gcslab {
namespace {

using Gcslab = GcslabShell;

constexpr const char* kCircle = R"yaml(kind: curve
name: circle
title: A circle
variables: [x, y]
equations: ["x^2 + y^2 = 1"]
box: {x: [-2, 2], y: [-2, "sqrt(4)"]}
origin: test
licence: none
)yaml";

constexpr const char* kConfig = R"yaml(experiment: tiny
title: Tiny
task: cover
problems: [curves/folium]
methods: [{name: natural}, {name: bernstein}]
parameters: {depth: 4}
report:
  - table: {file: cells, rows: problem, columns: method, values: [kept_cells, wall_s], best: min}
  - figure: {file: covers, kind: cover_panels, rows: problem, columns: method}
)yaml";

TEST_F(Gcslab, ListsWhatThereIs) {
  const Answer methods = shell("$gcslab list methods --kind cover");
  EXPECT_EQ(methods.exit_code, 0);
  EXPECT_TRUE(has(methods.out, "bernstein"));
  const Answer problems = shell("$gcslab list problems --kind surface --json");
  const auto json = nlohmann::json::parse(problems.out);
  EXPECT_GE(json.size(), 4u);
  EXPECT_EQ(shell("$gcslab list problems --kind surfaec").exit_code, 2);
  EXPECT_TRUE(has(shell("$gcslab list problems --kind surfaec").err, "did you mean 'surface'"));
}

TEST_F(Gcslab, DescribesMethodsProblemsTasksAndConfigs) {
  for (const char* name : {"natural", "cover", "curves/folium", "tahari-curves", "paper/tahari-figure-4.5"}) {
    const Answer answer = shell(std::string("$gcslab describe ") + name + " --json");
    ASSERT_EQ(answer.exit_code, 0) << answer.err;
    EXPECT_EQ(nlohmann::json::parse(answer.out).at("name"), name);
    EXPECT_EQ(shell(std::string("$gcslab describe ") + name).exit_code, 0);
  }
  const Answer misspelt = shell("$gcslab describe natrual");
  EXPECT_EQ(misspelt.exit_code, 2);
  EXPECT_TRUE(has(misspelt.err, "did you mean 'natural'"));
}

TEST_F(Gcslab, CoversACurveOfTheCorpus) {
  const Answer answer = shell("$gcslab cover curves/folium --depth 5 --method bernstein --json -");
  ASSERT_EQ(answer.exit_code, 0) << answer.err;
  const auto json = nlohmann::json::parse(answer.out);
  EXPECT_EQ(json.at("status"), "complete");
  EXPECT_EQ(json.at("kept").size(), json.at("kept_cells"));
  EXPECT_EQ(json.at("visited_per_level").at(0), 1);
  EXPECT_EQ(json.at("method").at("options").at("arithmetic"), "fast");
  EXPECT_TRUE(json.at("provenance").contains("compiler"));
}

TEST_F(Gcslab, CoversAFileOfTheUserAndDrawsIt) {
  write("circle.yaml", kCircle);
  const Answer answer =
      shell("$gcslab cover circle.yaml --cell-size 0.1 --split alternate --json c.json --figure c.svg");
  ASSERT_EQ(answer.exit_code, 0) << answer.err;
  EXPECT_TRUE(has(answer.out, "cells kept"));
  EXPECT_EQ(nlohmann::json::parse(text_of(folder_ / "c.json")).at("depth"), 6);
  EXPECT_TRUE(has(text_of(folder_ / "c.svg"), "<svg"));
}

TEST_F(Gcslab, AnotherBoxIsTaken) {
  const Answer answer =
      shell("$gcslab cover curves/folium --depth 2 --box \"x=[1,3/2],y=[-1,-1/2]\" --json -");
  EXPECT_EQ(nlohmann::json::parse(answer.out).at("domain"), nlohmann::json::parse("[[1,1.5],[-1,-0.5]]"));
  EXPECT_EQ(shell("$gcslab cover curves/folium --box \"x=[1,0]\"").exit_code, 2);
  EXPECT_EQ(shell("$gcslab cover curves/folium --box \"z=[0,1]\"").exit_code, 2);
  EXPECT_EQ(shell("$gcslab cover curves/folium --box \"x=[0,inf]\"").exit_code, 2);
}

TEST_F(Gcslab, BadInputIsOneLineAndExitCodeTwo) {
  write("broken.yaml", std::string(kCircle) + "colour: red\n");
  write("reversed.yaml",
        "kind: curve\nname: r\nvariables: [x, y]\nequations: [\"x\"]\nbox: {x: [1, 0], y: [0, 1]}\n"
        "origin: o\nlicence: l\n");
  const std::pair<const char*, const char*> cases[] = {
      {"$gcslab cover curves/folium --method bernstien", "did you mean 'bernstein'"},
      {"$gcslab cover curves/folum", "did you mean 'curves/folium'"},
      {"$gcslab cover missing.yaml", "unknown problem"},
      {"$gcslab cover broken.yaml", "broken.yaml:9: unknown key 'colour'"},
      {"$gcslab cover reversed.yaml", "reversed.yaml:5"},
      {"$gcslab cover curves/folium --set form=horner", "unknown option of bernstein 'form'"},
      {"$gcslab cover curves/folium --method natural --set form=horn", "expected one of"},
      {"$gcslab cover curves/folium --depth x", "--depth"},
      {"$gcslab cover curves/folium --depth 3 --json /dev/null/x", "cannot write"},
      {"$gcslab cover curves/folium --depth 3 --json /dev/full", "No space left"},
      {"$gcslab cover curves/folium --depth 3 --json - >/dev/full", "standard output cannot be written"},
      {"$gcslab cover curves/folium --depth 3 --figure f.png", ".svg or .pdf"},
      {"$gcslab cover curves/sphere --depth 2 --figure f.svg", "--figure"},
      {"$gcslab frobnicate", "gcslab --help"},
      {"$gcslab", "gcslab --help"},
      {"$gcslab run missing.yaml", "missing.yaml"},
      {"$gcslab report missing.yaml", "missing.yaml"},
  };
  for (const auto& [command, fragment] : cases) {
    const Answer answer = shell(command);
    EXPECT_EQ(answer.exit_code, 2) << command << "\n" << answer.err;
    EXPECT_TRUE(has(answer.err, fragment)) << command << "\n" << answer.err;
    EXPECT_EQ(lines(answer.err), 1u) << command << "\n" << answer.err;
  }
}

TEST_F(Gcslab, AFileSizeLimitIsReportedAndTheOldFileStays) {
  write("c.json", "old");
  const Answer answer = shell("(ulimit -f 1; $gcslab cover curves/folium --depth 7 --json c.json)");
  EXPECT_EQ(answer.exit_code, 2) << answer.err;
  EXPECT_TRUE(has(answer.err, "File too large")) << answer.err;
  EXPECT_EQ(text_of(folder_ / "c.json"), "old");
}

TEST_F(Gcslab, AMethodThatDoesNotApplySaysWhy) {
  const Answer answer = shell("$gcslab cover curves/wave --method bernstein");
  EXPECT_EQ(answer.exit_code, 4);
  EXPECT_TRUE(has(answer.err, "takes polynomials only"));
  EXPECT_EQ(shell("$gcslab cover curves/wave --depth 3").exit_code, 0);
}

TEST_F(Gcslab, ATimeoutEndsWithTheBoxesThatAreLeft) {
  const Answer answer = shell("$gcslab cover curves/chmutov-sextic --depth 12 --timeout 0.2 --json t.json");
  EXPECT_EQ(answer.exit_code, 3) << answer.err;
  const auto json = nlohmann::json::parse(text_of(folder_ / "t.json"));
  EXPECT_EQ(json.at("status"), "budget_exhausted");
  EXPECT_FALSE(json.at("undecided").empty());
}

TEST_F(Gcslab, ValidatesProblemsSuitesAndConfigs) {
  write("circle.yaml", kCircle);
  write("config.yaml", kConfig);
  write("bad.yaml", std::string(kConfig) + "titel: x\n");
  std::string misspelt = kConfig;
  misspelt.replace(misspelt.find("cover_panels"), 12, "cover_panel ");
  write("kind.yaml", misspelt);
  EXPECT_EQ(shell("$gcslab validate circle.yaml config.yaml").exit_code, 0);
  const Answer bad = shell("$gcslab validate bad.yaml circle.yaml");
  EXPECT_EQ(bad.exit_code, 1);
  EXPECT_TRUE(has(bad.out + bad.err, "bad.yaml:10: unknown key 'titel' (did you mean 'title'?)")) << bad.out;
  const Answer kind = shell("$gcslab run kind.yaml");
  EXPECT_EQ(kind.exit_code, 2);
  EXPECT_TRUE(has(kind.err, "did you mean 'cover_panels'")) << kind.err;
  const Answer all = shell("$gcslab validate $(find " GCSLAB_SOURCE_DIR "/data " GCSLAB_SOURCE_DIR
                           "/configs -name '*.yaml')");
  EXPECT_EQ(all.exit_code, 0) << all.out;
}

TEST_F(Gcslab, FromAConfigToATableAndAFigure) {
  write("tiny.yaml", kConfig);
  const Answer run = shell("$gcslab run tiny.yaml --out runs");
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const Answer report = shell("$gcslab report tiny.yaml --runs runs --out reports --reference none");
  ASSERT_EQ(report.exit_code, 0) << report.err;
  for (const char* file :
       {"cells.md", "cells.tex", "cells.csv", "covers.svg", "covers.pdf", "covers.gp", "covers.dat"}) {
    EXPECT_TRUE(fs::exists(folder_ / "reports/tiny" / file)) << file;
  }
  EXPECT_TRUE(fs::exists(folder_ / "reports/index.html"));
  EXPECT_TRUE(has(text_of(folder_ / "reports/tiny/cells.md"), "natural"));
  const Answer again = shell("$gcslab run tiny.yaml --out runs --explain");
  EXPECT_EQ(again.exit_code, 0);
  EXPECT_TRUE(has(again.out, "cached")) << again.out;
}

}  // namespace
}  // namespace gcslab
