// What a user's config shows of homotopy paths: values, curves, deformations, sketches.

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/gcslab_shell.h"

namespace gcslab {
namespace {

class PathFigures : public GcslabShell {};

TEST_F(PathFigures, AreDrawnFromAConfig) {
  write(
      "c.yaml",
      "experiment: paths\ntask: solve\nproblems: [polyhedra/octahedron]\n"
      "methods:\n  - {name: sketch_path, label: whole}\n  - {name: sketch_first_crossing, label: part}\n"
      "parameters: {traced_points: 500}\nreport:\n"
      "  - table: {file: t, rows: method, values: [classes, crossings, path_type]}\n"
      "  - figure: {file: path, kind: paths, x: P3_y, y: P4_z, bold: part}\n"
      "  - figure: {file: strip, kind: deformation, filter: {method: part}, count: 5}\n"
      "  - figure: {file: sketch, kind: figures, show: sketch, filter: {method: part}, dimensions: true}\n");
  const Answer run = shell("$gcslab run c.yaml --out runs");
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const Answer report = shell("$gcslab report c.yaml --runs runs --out reports --format md,svg,csv");
  ASSERT_EQ(report.exit_code, 0) << report.err;
  for (const char* file : {"path", "strip", "sketch"})
    EXPECT_FALSE(text_of(folder_ / "reports/paths" / (std::string(file) + ".svg")).empty()) << file;
  const std::string table = text_of(folder_ / "reports/paths/t.csv");
  EXPECT_TRUE(has(table, "cycle")) << table;
  const std::string data = text_of(folder_ / "reports/paths/path.dat");
  EXPECT_TRUE(has(data, ": whole\n") && has(data, ": part\n") && has(data, ": solutions\n"))
      << data.substr(0, 400);
  EXPECT_TRUE(has(text_of(folder_ / "reports/paths/strip.gp"), "'t = 1.00'"));
  EXPECT_TRUE(has(text_of(folder_ / "reports/paths/sketch.gp"), "'h0'"));
}

TEST_F(PathFigures, OfRandomSketchesFollowTheSeed) {
  write("c.yaml",
        "experiment: seeds\ntask: solve\nproblems: [polyhedra/octahedron]\nmethods: {name: sketch_path}\n"
        "parameters: {sketch: random}\nseeds: 2..3\nreport:\n"
        "  - table: {file: t, rows: seed, values: [crossings, steps]}\n");
  ASSERT_EQ(shell("$gcslab run c.yaml --out runs").exit_code, 0);
  ASSERT_EQ(shell("$gcslab report c.yaml --runs runs --out reports --format csv").exit_code, 0);
  const std::string table = text_of(folder_ / "reports/seeds/t.csv");
  const Answer own = shell("$gcslab solve polyhedra/octahedron --set random_sketch=3 --json -");
  const std::string steps = nlohmann::json::parse(own.out)["statistics"]["steps"].dump();
  EXPECT_TRUE(has(table, "\n3,steps,,," + steps) || has(table, "," + steps + ",")) << table << steps;
}

}  // namespace
}  // namespace gcslab
