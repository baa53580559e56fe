#include "experiments/reporting/figure.h"

#include <gtest/gtest.h>

#include "base/atomic_file.h"
#include "base/error.h"
#include "covering/cover_tree.h"
#include "experiments/reporting/cover_drawing.h"
#include "experiments/reporting/gnuplot.h"
#include "experiments/reporting/picture_file.h"
#include "unit/reporting/sample_rows.h"

namespace gcslab {
namespace {

ReportItem figure_item(const std::string& file, const std::string& kind) {
  ReportItem item = sample_item(file, {}, {}, {});
  item.form = ReportItem::Form::figure;
  item.kind = kind;
  return item;
}

/// A cover of the diagonal of the unit square.
Row cover_row(const std::string& method) {
  Row row = sample_row("curves/diagonal", method, 4, 1, "2");
  CoverTree tree({{0, 1}, {0, 1}}, 2, Split::all);
  for (const char c : std::string("1"
                                  "11001"
                                  "0"
                                  "0"
                                  "11001"))
    tree.append(c == '1');
  row.artifact = Json::parse(tree.to_json().dump());
  return row;
}

std::string file_text(const TemporaryFolder& folder, const std::string& name) {
  return read_file(folder.path() / name);
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(Figure, CoverPanelsDrawEveryRow) {
  const Row late = with_outcome(cover_row("slow"), "budget_exhausted", "wall limit of 60 s");
  ReportContext context = sample_context({cover_row("natural"), late});
  context.curve = [](const std::string&) { return std::vector<Polyline>{{{0, 0}, {1, 1}}}; };
  const FigureScript figure = draw_figure(figure_item("covers", "cover_panels"), context);
  EXPECT_TRUE(has(figure.commands(), "'kept 4 of 13 visited'")) << figure.commands();
  EXPECT_TRUE(has(figure.commands(), "timeout: wall"));
  EXPECT_TRUE(has(figure.data(), "curves/diagonal, natural, depth 2, seed 1, kept cells"));
  EXPECT_EQ(figure.notes.at(1),
            "Not drawn: curves/diagonal, slow, depth 2, seed 1 (timeout: wall limit of 60 s).");
}

TEST(Figure, PicturesAreTheSameEveryTime) {
  const ReportContext context = sample_context({cover_row("natural")});
  const FigureScript figure = draw_figure(figure_item("covers", "cover_panels"), context);
  const TemporaryFolder first;
  const TemporaryFolder second;
  write_figure(figure, "A caption", first.path(), "covers", {"svg", "pdf"});
  write_figure(figure, "A caption", second.path(), "covers", {"svg", "pdf"});
  for (const char* name : {"covers.svg", "covers.pdf", "covers.gp", "covers.dat"}) {
    EXPECT_EQ(file_text(first, name), file_text(second, name)) << name;
    EXPECT_FALSE(file_text(first, name).empty()) << name;
  }
}

TEST(Figure, EveryKindIsAcceptedByGnuplot) {
  std::vector<Row> rows;
  for (const char* depth : {"6", "7", "8"}) {
    for (const char* method : {"it's a_b", "{other}"}) rows.push_back(sample_row("p", method, 0, 0.1, depth));
  }
  rows[0].artifact = {{"panels",
                       {{{"title", "a'b"},
                         {"aspect", "equal"},
                         {"x", {0, 1}},
                         {"y", {0, 2}},
                         {"shapes",
                          {{{"kind", "polygon"}, {"style", "hull"}, {"points", {{0, 0}, {1, 0}, {1, 2}}}},
                           {{"kind", "label"}, {"points", {{0.5, 0.5}}}, {"text", "b_2 \"x\""}}}}}}}};
  for (Row& row : rows) {
    row.values["lower"] = "-1/2";
    row.values["upper"] = 1;
    row.values["exact_lower"] = 0;
    row.values["exact_upper"] = 1;
  }
  const ReportContext context = sample_context(rows);
  ReportItem series = figure_item("series", "series");
  series.values = {"kept_cells", "wall_s"};  // kept_cells are 0: nothing that a logarithmic axis could show
  set_option(series, "x", "depth");
  ReportItem bars = figure_item("bars", "range_bars");
  bars.filter["depth"] = {"6"};
  ReportItem drawing = figure_item("drawing", "drawing");
  drawing.filter = {{"depth", {"6"}}, {"method", {"it's a_b"}}};
  const TemporaryFolder folder;
  for (const ReportItem& item : {series, bars, drawing}) {
    write_figure(draw_figure(item, context), "It's a {caption}\nof two lines", folder.path(), item.file,
                 {"svg", "pdf"});
    EXPECT_TRUE(has(file_text(folder, item.file + ".svg"), "</svg>")) << item.kind;
    EXPECT_FALSE(has(file_text(folder, item.file + ".svg"), "crispEdges")) << item.kind;
  }
  EXPECT_TRUE(has(file_text(folder, "bars.svg"), "it's a_b")) << "names are no markup";
}

TEST(Figure, UnknownKindsAndOptionsAreRefusedWithTheirPlace) {
  try {
    check_figure(figure_item("f", "cover_panel"));
    FAIL();
  } catch (const InputError& error) {
    EXPECT_TRUE(has(error.what(),
                    "sample.yaml:12: unknown kind of figure 'cover_panel' (did you mean 'cover_panels'?)"))
        << error.what();
  }
  ReportItem item = figure_item("f", "series");
  set_option(item, "spread", "barrs");
  try {
    check_figure(item);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_TRUE(has(error.what(), "sample.yaml:14")) << error.what();
  }
}

TEST(Figure, KindsRefuseRowsOfOtherTasks) {
  const ReportContext context = sample_context({sample_row("p", "m", 1, 1)});
  EXPECT_THROW(draw_figure(figure_item("f", "cover_panels"), context), InputError);
  EXPECT_THROW(draw_figure(figure_item("f", "drawing"), context), InputError);
  EXPECT_THROW(draw_figure(figure_item("f", "series"), context), InputError) << "no x";
}

TEST(Gnuplot, ItsOwnWordsAreReported) {
  FigureScript figure;
  figure.height = 50;
  figure.command("plot 'there is no such file'");
  const TemporaryFolder folder;
  try {
    write_figure(figure, "broken", folder.path(), "broken", {"svg"});
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_TRUE(has(error.what(), "there is no such file")) << error.what();
  }
}

TEST(Program, EndsAreTold) {
  const TemporaryFolder folder;
  EXPECT_EQ(run_program({"gcslab-no-such-program"}, folder.path(), 5).exit_code, 127);
  EXPECT_EQ(run_program({"sh", "-c", "pwd >&2; exit 3"}, folder.path(), 5).exit_code, 3);
  EXPECT_EQ(run_program({"sh", "-c", "pwd >&2"}, folder.path(), 5).error_text, folder.path().string() + "\n");
  const ProgramEnd late = run_program({"sleep", "30"}, folder.path(), 0.05);
  EXPECT_TRUE(late.timed_out);
  EXPECT_EQ(late.exit_code, -1);
}

TEST(PictureFile, PathsAreWrittenShort) {
  EXPECT_EQ(shortened_path("M1.00,2.50 L3.00,2.50 \t\tL3.00,4.10 L5.25,6.00 Z  "), "M1,2.5H3V4.1L5.25,6Z");
}

TEST(CoverDrawing, SimplifiedLinesStayNear) {
  Polyline arc;
  for (int i = 0; i <= 1000; ++i) arc.push_back({i / 1000.0, i * (1000 - i) / 1e6});
  const Polyline few = simplified(arc, 1e-4);
  EXPECT_LT(few.size(), 100U);
  EXPECT_EQ(few.front(), arc.front());
  EXPECT_EQ(few.back(), arc.back());
}

}  // namespace
}  // namespace gcslab
