// Drawings of figures: which lines and faces a constraint system has, figures that are the same, and what
// gnuplot gets.

#include "experiments/solving/wireframe.h"

#include <gtest/gtest.h>

#include "base/atomic_file.h"
#include "base/error.h"
#include "experiments/reporting/class_alignment.h"
#include "experiments/reporting/figure.h"
#include "experiments/reporting/figures_picture.h"
#include "experiments/reporting/gnuplot.h"
#include "experiments/reporting/wireframe_table.h"
#include "geometry/constraint_system_reader.h"
#include "support/error_text.h"
#include "unit/reporting/sample_rows.h"

namespace gcslab {
namespace {

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

ConstraintSystem system_of(const std::string& text) {
  return read_constraint_system(YamlNode::parse(
      "kind: constraint_system\nname: test\n" + text + "origin: test\nlicence: none\n", "test.yaml"));
}

Wireframe corpus_wires(const std::string& name) {
  const ConstraintSystem system = read_constraint_system(
      YamlNode::load_file(std::string(GCSLAB_SOURCE_DIR) + "/data/polyhedra/" + name + ".yaml"));
  return wireframe_of(system, system.valuation(""));
}

std::size_t guides(const Wireframe& wires) {
  return static_cast<std::size_t>(std::ranges::count(wires.edges, true, &WireEdge::is_guide));
}

TEST(Wireframe, OfPolyhedraHasTheirEdgesAndCoplanarFaces) {
  const Wireframe octahedron = corpus_wires("octahedron");
  EXPECT_EQ(octahedron.edges.size(), 12U);
  EXPECT_TRUE(octahedron.faces.empty());
  EXPECT_EQ(octahedron.edges[1].label, "h1 = 1.17389");
  const Wireframe pentahedron = corpus_wires("pentahedron");
  EXPECT_EQ(pentahedron.edges.size(), 9U);
  ASSERT_EQ(pentahedron.faces.size(), 3U);
  for (const auto& face : pentahedron.faces) {
    ASSERT_EQ(face.size(), 4U);
    for (std::size_t k = 0; k < 4; ++k) {
      const std::size_t a = face[k], b = face[(k + 1) % 4];
      EXPECT_TRUE(std::ranges::any_of(pentahedron.edges,
                                      [&](const WireEdge& edge) {
                                        return (edge.from == a && edge.to == b) ||
                                               (edge.from == b && edge.to == a);
                                      }))
          << a << " " << b;
    }
  }
}

TEST(Wireframe, JoinsCoplanaritiesWithThreeCommonPoints) {
  const std::string pentagon =
      "universe: 3d\npoints: [A, B, C, D, E, F]\nconstraints:\n"
      "  - {distance: [A, B], parameter: h}\n  - {distance: [B, C], parameter: h}\n"
      "  - {distance: [C, D], parameter: h}\n  - {distance: [D, E], parameter: h}\n"
      "  - {distance: [E, A], parameter: h}\n  - {distance: [A, F], parameter: h}\n"
      "  - {coplanar: [A, B, C, D]}\n  - {coplanar: [E, A, C, D]}\n"
      "valuations: {wanted: {h: 1}}\n";
  const ConstraintSystem system = system_of(pentagon);
  const Wireframe wires = wireframe_of(system, system.valuation(""));
  ASSERT_EQ(wires.faces.size(), 1U);
  EXPECT_EQ(wires.faces[0], (std::vector<std::size_t>{0, 1, 2, 3, 4}));
}

TEST(Wireframe, HasGuidesWhereNoLengthIsGiven) {
  const ConstraintSystem system = system_of(
      "universe: 2d\npoints: [A, B, C, D]\nconstraints:\n  - {distance: [A, B], parameter: c}\n"
      "  - {angle: [B, A, C], parameter: w}\n  - {parallel: [A, B, C, D]}\n  - {equal_lengths: [A, B, C, "
      "D]}\n"
      "valuations: {wanted: {c: 5, w: 30 deg}}\n");
  const Wireframe wires = wireframe_of(system, system.valuation(""));
  EXPECT_EQ(wires.edges.size(), 3U);  // A B, the arm A C, and C D once
  EXPECT_EQ(guides(wires), 2U);
  ASSERT_EQ(wires.angles.size(), 1U);
  EXPECT_EQ(wires.angles[0].at, 0U);
  EXPECT_EQ(wires.angles[0].label, "w = 30°");
  EXPECT_TRUE(wires.faces.empty());
}

TEST(Wireframe, ReflectionsOfAFigureInItsFrameLookTheSame) {
  const Figure upright = {{0, 0, 0}, {1, 0, 0}, {-2, 3, 0}, {-1, -1, 0}, {5, -6, 7}, {1, 1, -9}};
  for (int signs = 0; signs < 8; ++signs) {
    Figure figure = upright;
    for (auto& point : figure) {
      for (int axis = 0; axis < 3; ++axis) {
        if ((signs >> axis & 1) != 0) point[static_cast<std::size_t>(axis)] *= -1;
      }
    }
    const std::vector<Sort> sorts(figure.size(), Sort::point);
    EXPECT_EQ(reflected_upright(figure, sorts, {0, 1, 2}), upright) << signs;
    EXPECT_EQ(reflected_upright(figure, sorts, {}), figure);
  }
}

FigurePicture sample_picture() {
  FigurePicture picture;
  picture.wires.names = {"A", "it's B", "C"};
  picture.wires.edges = {{0, 1, "c = -5"}, {1, 2, "a = 3"}, {.from = 2, .to = 0, .is_guide = true}};
  picture.wires.angles = {{1, 0, 2, "w = 30°"}};
  picture.figures = {{{{0, 0}, {5, 0}, {4, 3}}, 4, true}, {{{0, 0}, {5, 0}, {2, 1}}, 1, false}};
  return picture;
}

TEST(FigurePicture, IsReadBack) {
  const FigurePicture again = figure_picture_from_json(Json::parse(to_json(sample_picture()).dump()));
  EXPECT_EQ(to_json(again), to_json(sample_picture()));
  Json broken = to_json(sample_picture());
  broken["figures"]["edges"][0]["to"] = 3;
  EXPECT_TRUE(has(error_text([&] { figure_picture_from_json(broken); }), "point that it does not have"));
  broken = to_json(sample_picture());
  broken["figures"]["classes"][1]["points"].erase(2);
  EXPECT_TRUE(has(error_text([&] { figure_picture_from_json(broken); }), "lacks coordinates"));
  EXPECT_THROW(figure_picture_from_json(Json::parse("{\"panels\": []}")), InputError);
}

TEST(ClassAlignment, PutsFiguresThatAreTheSameIntoOneLine) {
  const FigurePicture first = sample_picture();
  FigurePicture second = first;
  std::swap(second.figures[0], second.figures[1]);
  for (auto& point : second.figures[1].places) point = {7 - point[1], point[0]};  // a rigid motion
  second.figures.push_back({{{0, 0}, {5, 0}, {2, 2}}, 1, true});
  using Line = AlignedLine;
  const auto lines = aligned_classes({&first, nullptr, &second});
  ASSERT_EQ(lines.size(), 3U);
  EXPECT_EQ(lines[0], (Line{0, std::nullopt, 1}));
  EXPECT_EQ(lines[1], (Line{1, std::nullopt, 0}));
  EXPECT_EQ(lines[2], (Line{std::nullopt, std::nullopt, 2}));
  second.wires.names[0] = "Z";  // another problem
  EXPECT_EQ(aligned_classes({&first, &second}).size(), 5U);
}

TEST(WireTable, InThePlaneNamesPointsAndParameters) {
  const FigureScript script = draw_figures(sample_picture(), "triangle, adaptive");
  for (const char* words : {"'A'", "'it''s B'", "'c = −5'", "'w = 30°'", "'4 solutions'",
                            "'1 solution, not certified'", "'triangle, adaptive'"})
    EXPECT_TRUE(has(script.commands(), words)) << words << "\n" << script.commands();
  EXPECT_TRUE(has(script.data(), "pairs of points without a length\n4 3\n0 0\n")) << script.data();
  EXPECT_TRUE(has(script.data(), "angles"));
  EXPECT_TRUE(script.notes.empty());
}

TEST(WireTable, InSpaceEdgesHaveDepth) {
  FigurePicture picture;
  picture.wires = corpus_wires("pentahedron");
  picture.figures = {{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.3, 1, 1}, {0.3, 0, 1}}, 8, true},
                     {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 2, 0}, {3, 0, 0}}, 4, true}};
  const FigureScript script = draw_figures(picture, "prism");
  EXPECT_TRUE(has(script.data(), "depth 1 of 6"));
  EXPECT_TRUE(has(script.data(), "depth 6 of 6"));
  EXPECT_TRUE(has(script.data(), "faces"));
  EXPECT_TRUE(has(script.commands(), "'4 solutions, flat'"));
  EXPECT_FALSE(has(script.commands(), "h0 =")) << "lengths are for the plane";
  ASSERT_EQ(script.notes.size(), 1U);
  const TemporaryFolder folder;
  write_figures_picture(picture, "prism", folder.path() / "prism.svg");
  EXPECT_TRUE(has(read_file(folder.path() / "prism.svg"), ">P5<"));
}

TEST(WireTable, AStripHasOneScale) {
  Wireframe small;
  small.names = {"A", "B"};
  small.edges = {{0, 1}};
  small.points = {{0, 0, 0}, {1, 0, 0}};
  Wireframe large = small;
  large.points[1] = {2, 0, 0};
  WireTableStyle style;
  style.view = View{0, 0};
  const FigureScript script = draw_strip({{small, "t = 0"}, {large, "t = 1"}}, 5, style);
  EXPECT_TRUE(has(script.commands(), "'t = 1'"));
  EXPECT_FALSE(has(script.commands(), "'A'"));
  // Equal scales: the ranges of both panels are equally wide.
  std::vector<double> widths;
  for (std::size_t at = script.commands().find("set xrange ["); at != std::string::npos;
       at = script.commands().find("set xrange [", at + 1)) {
    double low = 0, high = 0;
    ASSERT_EQ(std::sscanf(script.commands().c_str() + at, "set xrange [%lf:%lf]", &low, &high), 2);
    widths.push_back(high - low);
  }
  ASSERT_EQ(widths.size(), 2U);
  EXPECT_NEAR(widths[0], widths[1], 1e-8);
  EXPECT_GT(widths[1], 2);
}

Row figures_row(const std::string& method, const FigurePicture& picture) {
  Row row = sample_row("triangles/one", method, 0, 0.1, "2");
  row.artifact = to_json(picture);
  return row;
}

TEST(Figures, ShowEveryRow) {
  FigurePicture one = sample_picture();
  one.figures.pop_back();
  FigurePicture none = one;
  none.figures.clear();
  const Row late = with_outcome(figures_row("slow", one), "budget_exhausted", "wall limit of 60 s");
  ReportItem item = sample_item("f", {}, {}, {});
  item.form = ReportItem::Form::figure;
  item.kind = "figures";
  const ReportContext context =
      sample_context({figures_row("adaptive", sample_picture()), figures_row("sketch", one),
                      figures_row("newton", none), late});
  const FigureScript script = draw_figure(item, context);
  for (const char* words :
       {"'adaptive'", "'sketch'", "'4 solutions'", "'no figure'", "'timeout: wall limit of"})
    EXPECT_TRUE(has(script.commands(), words)) << words;
  EXPECT_TRUE(has(script.notes.front(), "Not drawn: triangles/one, slow"));
  set_option(item, "view", "20");
  EXPECT_TRUE(has(error_text([&] { draw_figure(item, context); }), "expected best, or degrees"));
  item.options.clear();
  EXPECT_TRUE(has(error_text([&] { draw_figure(item, sample_context({sample_row("p", "m", 1, 1)})); }),
                  "the rows hold no figures"));
}

ReportItem figures_item() {
  ReportItem item = sample_item("f", {}, {}, {});
  item.form = ReportItem::Form::figure;
  item.kind = "figures";
  return item;
}

TEST(Figures, OfOneColumnStandInLines) {
  ReportItem item = figures_item();
  const ReportContext context = sample_context({figures_row("adaptive", sample_picture())});
  EXPECT_TRUE(has(draw_figure(item, context).data(), "line 2, column 1"));
  set_option(item, "per_line", "2");
  const FigureScript script = draw_figure(item, context);
  EXPECT_TRUE(has(script.data(), "line 1, column 2")) << script.data();
  EXPECT_FALSE(has(script.data(), "line 2"));
  EXPECT_TRUE(has(script.commands(), "'c = −5'"));
  set_option(item, "parameters", "false");
  EXPECT_FALSE(has(draw_figure(item, context).commands(), "'c = −5'"));
}

TEST(Figures, SketchesStandSideBySide) {
  FigurePicture one = sample_picture(), other = sample_picture();
  one.sketch = {{0, 0}, {5, 0}, {4, 3}};
  other.sketch = {{0, 0}, {1, 0}, {4, 3}};
  Row first = figures_row("m", one), second = figures_row("m", other);
  second.axes = {{"problem", "triangles/two"}, {"method", "m"}, {"depth", "2"}, {"seed", "1"}};
  ReportItem item = figures_item();
  item.columns = {"problem"};
  set_option(item, "show", "sketch");
  const FigureScript script = draw_figure(item, sample_context({first, second}));
  EXPECT_TRUE(has(script.data(), "line 1, column 2")) << script.data();
  EXPECT_FALSE(has(script.data(), "line 2"));
  EXPECT_TRUE(has(script.commands(), "'c'")) << "parameters without values";
}

TEST(Figures, NewSketchesStandBesideTheSolutionThatTheyComeFrom) {
  FigurePicture picture = sample_picture();
  picture.new_sketches = {{"branch +-", {{0, 0}, {5, 0}, {4, 3}}}, {"branch -+", {{0, 0}, {5, 0}, {4, -3}}}};
  ReportItem item = figures_item();
  set_option(item, "show", "new_sketches");
  set_option(item, "per_line", "3");
  const FigureScript script = draw_figure(item, sample_context({figures_row("m", picture)}));
  EXPECT_TRUE(has(script.data(), "line 1, column 3")) << script.data();
  EXPECT_TRUE(has(script.commands(), "the solution") && has(script.commands(), "branch +-") &&
              has(script.commands(), "branch -+"));
  EXPECT_TRUE(has(script.commands(), "'c'")) << "parameters without values";
  const auto without = [&] { draw_figure(item, sample_context({figures_row("m", sample_picture())})); };
  EXPECT_TRUE(has(error_text(without), "no new sketches"));
}

}  // namespace
}  // namespace gcslab
