// Figures and tables of paths and of what many sketches lead to.

#include <gtest/gtest.h>

#include "experiments/reporting/figure.h"
#include "experiments/reporting/table.h"
#include "experiments/solving/figure_picture.h"
#include "experiments/solving/traced_path.h"
#include "support/error_text.h"
#include "unit/reporting/sample_rows.h"

namespace gcslab {
namespace {

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// Three points in the plane, A at the origin and B on the x axis; C moves.
TracedPath sample_path() {
  TracedPath path{{"B_x", "C_x", "C_y"}, {{-1, -1}, {0, -1}, {1, 2}}, {}, 1, {}, {}};
  path.points = {{{1, 0, -9}, -0.5}, {{1, 0, 1}, 0}, {{1, 0.5, 2}, 0.5}, {{1, 1, 3}, 1}};
  path.crossings = {{{1, 1, 3}, 1}};
  path.critical = {{{1, 0.5, 2}, 0.5}};
  return path;
}

/// Figures of two points, at these distances.
FigurePicture sample_figures(const std::vector<double>& distances, bool is_certified = true) {
  FigurePicture picture;
  picture.wires.names = {"A", "B", "C"};
  picture.wires.edges = {{0, 1, "c = 1"}};
  for (const double d : distances) picture.figures.push_back({{{0, 0}, {d, 0}, {0, 1}}, 1, is_certified});
  return picture;
}

Row path_row(const std::string& method, const TracedPath& path) {
  Row row = sample_row("p", method, 1, 1);
  row.artifact = to_json(sample_figures({1}));
  row.artifact["path"] = to_json(path);
  return row;
}

FigureScript drawn(const std::string& kind, std::vector<Row> rows,
                   const std::map<std::string, std::string>& options) {
  ReportItem item = sample_item("f", {}, {}, {});
  item.form = ReportItem::Form::figure;
  item.kind = kind;
  for (const auto& [name, text] : options) item.options[name] = {text, {"sample.yaml", 13}};
  return draw_figure(item, sample_context(std::move(rows)));
}

TEST(TracedPath, SurvivesItsJson) {
  const TracedPath path = traced_path_from_json(to_json(sample_path()));
  EXPECT_EQ(path.names, sample_path().names);
  EXPECT_EQ(path.sketch, 1U);
  ASSERT_EQ(path.points.size(), 4U);
  EXPECT_EQ(path.points[2].t, 0.5);
  EXPECT_EQ(path.figure(path.points[2]), (Figure{{0, 0}, {1, 0}, {0.5, 2}}));
  Json lacking = to_json(sample_path());
  lacking["points"][0] = {1, 2};
  EXPECT_TRUE(has(error_text([&] { traced_path_from_json(lacking); }), "without all its unknowns"));
}

TEST(PathsFigure, DrawsTheCurveWithItsMarks) {
  const FigureScript script = drawn("paths", {path_row("m", sample_path())}, {{"x", "C_x"}});
  EXPECT_TRUE(has(script.data(), "0 -0.5\n0 0\n0.5 0.5\n1 1\n")) << script.data();
  EXPECT_TRUE(has(script.data(), "sketch\n0 0\n"));
  EXPECT_TRUE(has(script.data(), "solutions\n1 1\n"));
  EXPECT_TRUE(has(script.data(), "critical points\n0.5 0.5\n"));
}

TEST(PathsFigure, IsCutWhereItLeavesTheReach) {
  const FigureScript script =
      drawn("paths", {path_row("m", sample_path())}, {{"x", "C_y"}, {"reach", "1.5"}});
  EXPECT_TRUE(has(script.data(), "\n1 0\n2 0.5\n")) << script.data();
  EXPECT_FALSE(has(script.data(), "-9")) << script.data();
  EXPECT_FALSE(has(script.data(), "solutions")) << "the solution is out of reach";
}

TEST(PathsFigure, SaysWhatItLacks) {
  const auto error = [](const std::string& kind, std::vector<Row> rows,
                        const std::map<std::string, std::string>& options) {
    return error_text([&] { drawn(kind, std::move(rows), options); });
  };
  EXPECT_TRUE(has(error("paths", {path_row("m", sample_path())}, {{"x", "C_z"}}), "C_z"));
  EXPECT_TRUE(has(error("paths", {sample_row("p", "m", 1, 1)}, {{"x", "C_x"}}), "traced_points"));
  EXPECT_TRUE(
      has(error("deformation", {path_row("m", sample_path()), path_row("n", sample_path())}, {}), "one job"));
}

TEST(DeformationFigure, HasItsFiguresAtEqualDistances) {
  const FigureScript script = drawn("deformation", {path_row("m", sample_path())}, {{"count", "3"}});
  EXPECT_TRUE(has(script.commands(), "'t = 0.00'") || has(script.commands(), "'t = −0.50'"));
  EXPECT_TRUE(has(script.commands(), "'t = 1.00'")) << script.commands();
}

Table built(const std::string& kind, ReportItem item, std::vector<Row> rows) {
  item.kind = kind;
  return build_table(item, sample_context(std::move(rows)));
}

TEST(CountsTable, CountsEachNumberThatOccurs) {
  std::vector<Row> rows = {sample_row("p", "m", 4, 1, "8", "1"), sample_row("p", "m", 2, 1, "8", "2"),
                           sample_row("p", "m", 4, 1, "8", "3")};
  rows.push_back(with_outcome(sample_row("p", "m", 4, 1, "8", "4"), "failed", "so"));
  const Table table = built("counts", sample_item("t", {"method"}, {}, {"kept_cells"}), rows);
  ASSERT_EQ(table.column_heads.size(), 3U);
  EXPECT_EQ(table.column_heads[0][0], "2");
  const TableLine& line = table.blocks.at(0).lines.at(0);
  EXPECT_EQ(line.cells[0].text, "1");
  EXPECT_EQ(line.cells[1].text, "2");
  EXPECT_EQ(line.cells[2].text, "1") << "the job without a result";
}

TEST(DeviationsTable, CountsJobsThatDifferFromTheReference) {
  ReportItem item = sample_item("t", {"method"}, {}, {"kept_cells"});
  item.options["reference"] = {"sure", {"sample.yaml", 13}};
  const std::vector<Row> rows = {
      sample_row("p", "sure", 4, 1, "8", "1"), sample_row("p", "sure", 2, 1, "8", "2"),
      sample_row("p", "other", 4, 1, "8", "1"), sample_row("p", "other", 3, 1, "8", "2")};
  const Table table = built("deviations", item, rows);
  ASSERT_EQ(table.blocks.at(0).lines.size(), 2U);
  EXPECT_EQ(table.blocks[0].lines[0].cells[0].text, "0 of 2");
  EXPECT_EQ(table.blocks[0].lines[1].cells[0].text, "1 of 2");
  item.options["reference"].text = "nobody";
  EXPECT_TRUE(has(error_text([&] { built("deviations", item, rows); }), "nobody"));
}

TEST(BasinsTable, TellsFiguresApart) {
  const auto row = [](const std::string& seed, const FigurePicture& picture) {
    Row result = sample_row("p", "m", 1, 1, "8", seed);
    result.artifact = to_json(picture);
    return result;
  };
  const Table table = built("basins", sample_item("t", {}, {}, {}),
                            {row("1", sample_figures({1, 2})), row("2", sample_figures({2})),
                             row("3", sample_figures({})), row("4", sample_figures({3}, false))});
  const std::vector<std::pair<std::string, std::string>> expected = {{"1", "2"},
                                                                     {"2", "1"},
                                                                     {"singular figures", "1"},
                                                                     {"none", "1"},
                                                                     {"different figures, certified", "2"},
                                                                     {"jobs", "4"}};
  ASSERT_EQ(table.blocks.at(0).lines.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(table.blocks[0].lines[i].heads[0], expected[i].first);
    EXPECT_EQ(table.blocks[0].lines[i].cells[0].text, expected[i].second) << expected[i].first;
  }
}

TEST(DistributionFigure, IsTheShareOfJobsWithSoManyOrMore) {
  ReportItem item = sample_item("f", {}, {}, {"kept_cells"});
  item.form = ReportItem::Form::figure;
  item.kind = "distribution";
  const FigureScript script = draw_figure(
      item, sample_context({sample_row("p", "m", 2, 1, "8", "1"), sample_row("p", "m", 4, 1, "8", "2"),
                            sample_row("p", "m", 2, 1, "8", "3"), sample_row("p", "m", 5, 1, "8", "4")}));
  EXPECT_TRUE(has(script.data(), "0 100\n2 100\n4 50\n5 25\n")) << script.data();
}

}  // namespace
}  // namespace gcslab
