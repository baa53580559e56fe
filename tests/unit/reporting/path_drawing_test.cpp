// Paths on paper: where their points stand, and that every mark is drawn.

#include "experiments/reporting/path_drawing.h"

#include <gtest/gtest.h>

#include "base/atomic_file.h"
#include "experiments/reporting/gnuplot.h"
#include "unit/reporting/sample_rows.h"

namespace gcslab {
namespace {

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

PathPicture sample_paths() {
  return {{"B_x", "C_y"},
          {{"linear", {{0, 0, 0}, {1, 0, 1}, {2, 2, 0.5}}}, {"compact", {{0, 0, 0}, {2, 1, 1}}}},
          {{0, 0, 0}},
          {{1, 0, 1}, {2, 1, 1}},
          {{2, 2, 0.5}}};
}

TEST(PathDrawing, FlatShowsTheFirstUnknownAgainstT) {
  PathStyle style;
  style.is_flat = true;
  const FigureScript script = draw_paths(sample_paths(), style);
  EXPECT_TRUE(has(script.data(), "linear\n0 0\n1 1\n2 0.5\n")) << script.data();
  EXPECT_TRUE(has(script.data(), "sketch\n0 0\n"));
  EXPECT_TRUE(has(script.data(), "solutions\n1 1\n2 1\n"));
  EXPECT_TRUE(has(script.data(), "critical points\n2 0.5\n"));
  EXPECT_TRUE(has(script.commands(), "'B_x'"));
  EXPECT_FALSE(has(script.commands(), "'C_y'"));
}

TEST(PathDrawing, InSpaceIsSeenInTheUnitCube) {
  PathStyle style;
  style.view = View{0, 0};  // the first unknown across, t upwards
  const FigureScript script = draw_paths(sample_paths(), style);
  EXPECT_TRUE(has(script.data(), "sketch\n0 0\n")) << script.data();
  EXPECT_TRUE(has(script.data(), "solutions\n0.5 1\n1 1\n")) << script.data();
  EXPECT_TRUE(has(script.data(), "critical points\n1 0.5\n"));
  EXPECT_TRUE(has(script.data(), "plane t = 1\n0 1\n1 1\n1 1\n0 1\n0 1\n"));
  for (const char* words : {"'B_x'", "'C_y'", "'t'", "'linear'", "'compact'"})
    EXPECT_TRUE(has(script.commands(), words)) << words;
  ASSERT_EQ(script.notes.size(), 1U);
  EXPECT_EQ(script.notes[0],
            "Grey: t = 0 and t = 1. Squares: sketches. Discs: solutions. Rings: critical points.");
}

TEST(PathDrawing, TellsCurvesApartByDashes) {
  const std::string commands = draw_paths(sample_paths(), {}).commands();
  EXPECT_TRUE(has(commands, "dt 1 lw 1.1"));
  EXPECT_TRUE(has(commands, "dt 2 lw 1.1"));
  PathPicture one = sample_paths();
  one.curves.pop_back();
  EXPECT_FALSE(has(draw_paths(one, {}).commands(), "'linear'")) << "one curve needs no legend";
}

TEST(PathDrawing, IsAcceptedByGnuplot) {
  const TemporaryFolder folder;
  PathPicture still = sample_paths();  // a path that does not move in one unknown
  for (PathCurve& curve : still.curves) {
    for (PathPoint& point : curve.points) point[1] = 3;
  }
  for (auto* points : {&still.sketches, &still.solutions, &still.critical}) {
    for (PathPoint& point : *points) point[1] = 3;
  }
  for (const bool is_flat : {false, true}) {
    PathStyle style;
    style.is_flat = is_flat;
    for (const PathPicture& picture : {sample_paths(), still}) {
      write_figure(draw_paths(picture, style), "paths", folder.path(), "paths", {"svg", "pdf"});
      EXPECT_TRUE(has(read_file(folder.path() / "paths.svg"), "</svg>"));
    }
  }
}

}  // namespace
}  // namespace gcslab
