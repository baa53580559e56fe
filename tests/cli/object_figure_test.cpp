// What a user's config shows of figures with lines, planes, circles and spheres.

#include <gtest/gtest.h>

#include "cli/gcslab_shell.h"

namespace gcslab {
namespace {

class ObjectFigures : public GcslabShell {};

TEST_F(ObjectFigures, ShowEverySortInSpace) {
  write("sorts.yaml",
        "kind: constraint_system\nname: sorts\nuniverse: 3d\npoints: [A, B, C]\nlines: [axis]\n"
        "planes: [ground]\ncircles: [ring]\nspheres: [ball]\nconstraints:\n"
        "  - {distance: [A, B], parameter: c}\n  - {distance: [B, C], parameter: a}\n"
        "  - {distance: [C, A], parameter: b}\n  - {incidence: [A, axis]}\n  - {incidence: [B, axis]}\n"
        "  - {incidence: [A, ground]}\n  - {incidence: [B, ground]}\n  - {incidence: [C, ground]}\n"
        "  - {centre: [C, ball]}\n  - {radius: [ball], parameter: r}\n  - {centre: [A, ring]}\n"
        "  - {radius: [ring], parameter: q}\nvaluations: {wanted: {a: 3, b: 4, c: 5, r: 1, q: 2}}\n"
        "sketch: {A: [0, 0, 0], B: [4, 0, 0], C: [1, 3, 0], axis: {through: [[0, 0, 0], [4, 0, 0]]},\n"
        "  ground: {through: [[0, 0, 0], [4, 0, 0], [1, 3, 0]]},\n"
        "  ring: {centre: [0, 0, 0], radius: 1.5, normal: [0, 1, 1]}, ball: {centre: [1, 3, 0], radius: 1}}\n"
        "origin: test\nlicence: none\n");
  write("c.yaml",
        "experiment: sorts\ntask: solve\nproblems: [sorts.yaml]\n"
        "methods: {name: levenberg_marquardt_from_sketch}\nreport:\n"
        "  - figure: {file: solved, kind: figures, dimensions: true}\n"
        "  - figure: {file: sketch, kind: figures, show: sketch}\n");
  const Answer run = shell("$gcslab run c.yaml --out runs");
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const Answer report = shell("$gcslab report c.yaml --runs runs --out reports --format svg");
  ASSERT_EQ(report.exit_code, 0) << report.err;
  for (const std::string file : {"solved", "sketch"}) {
    const std::string picture = text_of(folder_ / "reports/sorts" / (file + ".svg"));
    for (const char* name : {">A<", ">axis<", ">ground<", ">ring<", ">ball<"})
      EXPECT_TRUE(has(picture, name)) << file << name;
    const std::string data = text_of(folder_ / "reports/sorts" / (file + ".dat"));
    for (const char* layer :
         {"shade of ground", "shade of ball", "curves, depth", "planes, depth", "circles"})
      EXPECT_TRUE(has(data, layer)) << file << layer;
  }
  EXPECT_TRUE(has(text_of(folder_ / "reports/sorts/solved.svg"), ">q = 2<"));
  EXPECT_FALSE(has(text_of(folder_ / "reports/sorts/sketch.svg"), ">q"));
}

TEST_F(ObjectFigures, ShowThePathOfALine) {
  write(
      "c.yaml",
      "experiment: lines\ntask: solve\nproblems: [sketches/line-at-distances]\nmethods: {name: sketch_path}\n"
      "parameters: {traced_points: 100}\nreport:\n  - figure: {file: strip, kind: deformation, count: 4}\n");
  ASSERT_EQ(shell("$gcslab run c.yaml --out runs").exit_code, 0);
  const Answer report = shell("$gcslab report c.yaml --runs runs --out reports --format svg");
  ASSERT_EQ(report.exit_code, 0) << report.err;
  const std::string data = text_of(folder_ / "reports/lines/strip.dat");
  EXPECT_TRUE(has(data, "line 1, column 1") && has(data, "curves, depth 6 of 6")) << data.substr(0, 500);
}

}  // namespace
}  // namespace gcslab
