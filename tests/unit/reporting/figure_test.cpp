#include "experiments/reporting/figure.h"

#include <gtest/gtest.h>

#include "base/atomic_file.h"
#include "base/error.h"
#include "covering/cover_tree.h"
#include "experiments/reporting/cover_drawing.h"
#include "experiments/reporting/gnuplot.h"
#include "experiments/reporting/picture_file.h"
#include "experiments/solving/search_picture_json.h"
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
  context.curve = [](const std::string&) { return ProblemCurves{{{{{0, 0}, {1, 1}}}}, {}}; };
  const FigureScript figure = draw_figure(figure_item("covers", "cover_panels"), context);
  EXPECT_TRUE(has(figure.commands(), "'kept 4 of 13 visited'")) << figure.commands();
  EXPECT_TRUE(has(figure.commands(), "timeout: wall"));
  EXPECT_TRUE(has(figure.data(), "curves/diagonal, natural, depth 2, seed 1, kept cells"));
  EXPECT_EQ(figure.notes.at(1),
            "Not drawn: curves/diagonal, slow, depth 2, seed 1 (timeout: wall limit of 60 s).");
}

RecordedBox recorded(BoxFate fate, std::vector<Box> stages, int reductions) {
  RecordedBox box;
  box.fate = fate;
  box.stages = std::move(stages);
  box.reductions = reductions;
  return box;
}

/// The unit square is reduced, cut at x = 1/2, and the halves are a root's box and an empty one.
SearchPicture sample_search() {
  return {{{0, 1}, {0, 1}},
          {recorded(BoxFate::cut, {{{0, 1}, {0, 1}}, {{0, 1}, {0, 0.75}}}, 1),
           recorded(BoxFate::root, {{{0, 0.5}, {0, 0.75}}, {{0.25, 0.25}, {0.5, 0.5}}}, 1),
           recorded(BoxFate::empty, {{{0.5, 1}, {0, 0.75}}}, 1)},
          3,
          {{0.25, 0.5}}};
}

Row search_row(const SearchPicture& picture) {
  Row row = sample_row("conics/two", "LP reduction", 0, 0.1, "2");
  row.artifact = to_json(picture);
  return row;
}

TEST(Figure, BoxesTellTheFateOfEveryPart) {
  const SearchPicture picture = sample_search();
  ReportContext context = sample_context({search_row(picture)});
  context.curve = [](const std::string&) {
    return ProblemCurves{{{{{0, 0}, {1, 1}}}}, {{{{0, 1}, {1, 0}}}}};
  };
  const FigureScript figure = draw_figure(figure_item("boxes", "boxes"), context);
  EXPECT_TRUE(has(figure.commands(), "'3 boxes, 3 reductions, 1 root'")) << figure.commands();
  for (const char* layer : {"cut off by reductions", "empty boxes", "boxes taken", "reduced boxes",
                            "equation 1", "border of inequality 1", "roots"})
    EXPECT_TRUE(has(figure.data(), std::string("LP reduction, depth 2, seed 1, ") + layer)) << layer;
  EXPECT_TRUE(has(figure.data(), "empty boxes\n0.5 0\n1 0\n1 0.75\n0.5 0.75\n0.5 0\n")) << figure.data();
  EXPECT_FALSE(has(figure.data(), "root boxes")) << "a point is no area";
  const TemporaryFolder folder;
  write_figure(figure, "boxes", folder.path(), "boxes", {"svg"});
  EXPECT_TRUE(has(file_text(folder, "boxes.svg"), "</svg>"));
}

TEST(Figure, BoxesSayWhatTheyNeedAndWhatTheyLeaveOut) {
  const ReportItem item = figure_item("boxes", "boxes");
  try {
    draw_figure(item, sample_context({sample_row("p", "m", 1, 1)}));
    FAIL();
  } catch (const InputError& error) {
    EXPECT_TRUE(has(error.what(), "recorded_boxes")) << error.what();
  }
  SearchPicture space = sample_search();
  space.domain.emplace_back(0, 1);
  for (RecordedBox& box : space.boxes) {
    for (Box& stage : box.stages) stage.emplace_back(0, 1);
  }
  space.roots = {{0.25, 0.5, 0.75}};
  space.told = 9;
  ReportItem turned = item;
  set_option(turned, "upwards", "2");
  const FigureScript figure = draw_figure(turned, sample_context({search_row(space)}));
  EXPECT_TRUE(has(figure.data(), "roots\n0.25 0.75\n")) << figure.data();
  EXPECT_FALSE(has(figure.data(), "empty boxes")) << "boxes that are seen through each other are not filled";
  EXPECT_TRUE(has(figure.commands(), "'9 boxes, 1 root'"));
  EXPECT_EQ(figure.notes.back(), "Of long searches only the first boxes are drawn.");
  set_option(turned, "across", "2");
  EXPECT_THROW(draw_figure(turned, sample_context({search_row(space)})), InputError);
}

TEST(SearchPicture, IsReadBack) {
  const SearchPicture picture = sample_search();
  const SearchPicture again = search_picture_from_json(Json::parse(to_json(picture).dump()));
  EXPECT_EQ(again.domain, picture.domain);
  EXPECT_EQ(again.roots, picture.roots);
  EXPECT_EQ(again.told, picture.told);
  ASSERT_EQ(again.boxes.size(), picture.boxes.size());
  for (std::size_t i = 0; i < again.boxes.size(); ++i) {
    EXPECT_EQ(again.boxes[i].fate, picture.boxes[i].fate);
    EXPECT_EQ(again.boxes[i].stages, picture.boxes[i].stages);
    EXPECT_EQ(again.boxes[i].reductions, picture.boxes[i].reductions);
  }
  EXPECT_THROW(search_picture_from_json(Json::parse("{\"panels\": []}")), InputError);
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
