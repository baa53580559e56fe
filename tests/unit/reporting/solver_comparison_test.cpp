#include "experiments/reporting/solver_comparison.h"

#include <cmath>
#include <gtest/gtest.h>

#include "base/atomic_file.h"
#include "base/error.h"
#include "experiments/reporting/figure.h"
#include "experiments/reporting/gnuplot.h"
#include "experiments/reporting/table.h"
#include "experiments/reporting/table_writers.h"
#include "support/error_text.h"
#include "unit/reporting/sample_rows.h"

namespace gcslab {
namespace {

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// A row of the task `solve` that took `cpu_s`.
Row solve_row(const std::string& problem, const std::string& method, double cpu_s, std::int64_t solutions,
              std::int64_t known, std::int64_t undecided = 0) {
  Row row = sample_row(problem, method, 0, 0);
  row.axes = {{"problem", problem}, {"method", method}, {"seed", "1"}};
  row.status = undecided == 0 ? "complete" : "partial";
  row.values = {
      {"solutions", solutions}, {"known_solutions", known}, {"undecided", undecided}, {"boxes", 10}};
  row.timings = {{"cpu_s", {cpu_s}}};
  return row;
}

Row timeout_row(const std::string& problem, const std::string& method) {
  return with_outcome(solve_row(problem, method, 0, 0, 0), "budget_exhausted", "CPU limit of 10 s");
}

ReferenceTable other_program() {
  ReferenceTable table;
  table.name = "other";
  table.title = "Figures of another program";
  table.origin = "elsewhere";
  table.methods = {"other A", "other B"};
  table.runs = {{"p/one", "other A", Status::complete, "", {{"cpu_s", 4}}, {{"solutions", 2}}},
                {"p/one", "other B", Status::complete, "", {{"cpu_s", 1}}, {}},
                {"p/two", "other A", Status::budget_exhausted, "its limit", {{"cpu_s", 60}}, {}},
                {"p/three", "other A", Status::complete, "", {{"cpu_s", 0.25}}, {}},
                {"p/elsewhere", "other A", Status::complete, "", {{"cpu_s", 5}}, {}}};
  return table;
}

/// Quick solves one, two and four; slow solves one and two; nobody solves five. Three ends with boxes
/// undecided. Baseline loses a root of two.
ReportContext contest() {
  Row lossy = solve_row("p/two", "baseline", 1, 3, 4);
  lossy.status = "partial";
  ReportContext context = {
      "contest",
      "A contest",
      "made up",
      1,
      {"baseline"},
      {},
      RowTable({"problem", "method", "seed"},
               {solve_row("p/one", "quick", 0.5, 2, 2), solve_row("p/one", "slow", 2, 2, 2),
                solve_row("p/one", "baseline", 0.5, 2, 2), solve_row("p/two", "quick", 2, 4, 4),
                solve_row("p/two", "slow", 8, 4, 4), lossy, solve_row("p/three", "quick", 1, 1, 3, 5),
                timeout_row("p/three", "slow"), timeout_row("p/three", "baseline"),
                solve_row("p/four", "quick", 3, 7, 6), timeout_row("p/four", "slow"),
                timeout_row("p/four", "baseline"), timeout_row("p/five", "quick"),
                timeout_row("p/five", "slow"), timeout_row("p/five", "baseline")}),
      {}};
  context.limits.cpu_s = 10;
  context.references.emplace("other", other_program());
  return context;
}

ReportItem item_of_kind(const std::string& kind, ReportItem::Form form = ReportItem::Form::table) {
  ReportItem item = sample_item("t", {}, {}, {});
  item.form = form;
  item.kind = kind;
  return item;
}

void refer_to(ReportItem& item, const std::string& name) { item.references = {{name, {"sample.yaml", 15}}}; }

TEST(ShiftedGeometricMean, EqualsItsDefinition) {
  EXPECT_DOUBLE_EQ(shifted_geometric_mean({1, 4}, 0), 2);
  EXPECT_DOUBLE_EQ(shifted_geometric_mean({2, 7}, 1), std::sqrt(24.0) - 1);
  EXPECT_NEAR(shifted_geometric_mean({0, 0, 7}, 1), 1, 1e-15) << "cube root of 8, less 1";
  EXPECT_NEAR(shifted_geometric_mean({5}, 10), 5, 1e-14);
  EXPECT_EQ(shifted_geometric_mean({0, 0, 0}, 0.01), 0);
  EXPECT_NEAR(shifted_geometric_mean({1e-15, 1e-15}, 0.01), 1e-15, 1e-29) << "costs far below the shift";
}

TEST(ShiftedGeometricMean, AShiftLeavesScalesFarBelowItOut) {
  const double fast = shifted_geometric_mean({1e-6, 1}, 0.01),
               faster = shifted_geometric_mean({1e-9, 1}, 0.01);
  EXPECT_NEAR(fast, faster, 1e-5);
}

TEST(PerformanceProfiles, EqualThoseByHand) {
  // Dolan and More: ratios 1, 2, - and 3, 1, 1; the last problem is solved by none.
  const auto profiles =
      performance_profiles({{1.0, 3.0}, {4.0, 2.0}, {std::nullopt, 7.0}, {std::nullopt, std::nullopt}}, 1e-3);
  ASSERT_EQ(profiles.size(), 2u);
  EXPECT_EQ(profiles[0].ratios, (std::vector<double>{1, 2}));
  EXPECT_EQ(profiles[1].ratios, (std::vector<double>{1, 1, 3}));
  EXPECT_EQ(profiles[0].share(1), 0.25);
  EXPECT_EQ(profiles[0].share(1.99), 0.25);
  EXPECT_EQ(profiles[0].share(2), 0.5);
  EXPECT_EQ(profiles[1].share(1), 0.5);
  EXPECT_EQ(profiles[1].share(1e9), 0.75) << "what nobody solves counts among all";
}

TEST(PerformanceProfiles, CostsBelowTheFloorAreNotToldApart) {
  const auto profiles = performance_profiles({{1e-6, 2e-4, 2e-3}}, 1e-3);
  EXPECT_EQ(profiles[0].ratios, std::vector<double>{1});
  EXPECT_EQ(profiles[1].ratios, std::vector<double>{1});
  EXPECT_EQ(profiles[2].ratios, std::vector<double>{2});
}

TEST(SolverComparison, TellsLostOpenAndFalseRootsApart) {
  const ReportContext context = contest();
  const SelectedRows rows(context, item_of_kind("summary"));
  const SolverComparison comparison(rows.all());
  ASSERT_EQ(comparison.methods(), (std::vector<std::string>{"quick", "slow", "baseline"}));
  const std::size_t quick = 0, baseline = 2, two = 1, three = 2, four = 3;
  EXPECT_EQ(comparison.lost_roots(two, baseline), 1);
  EXPECT_EQ(comparison.open_roots(two, baseline), 0);
  EXPECT_EQ(comparison.open_roots(three, quick), 2) << "they may lie in the boxes left undecided";
  EXPECT_EQ(comparison.lost_roots(three, quick), 0);
  EXPECT_EQ(comparison.false_roots(four, quick), 1);
  EXPECT_EQ(comparison.lost_roots(three, baseline), 0) << "it ran out of time: nothing is lost yet";
  EXPECT_FALSE(comparison.is_solved(two, baseline, Solved::ended));
  EXPECT_TRUE(comparison.is_solved(0, baseline, Solved::ended));
  EXPECT_FALSE(comparison.is_solved(four, quick, Solved::ended)) << "a root too many";
  EXPECT_TRUE(comparison.is_solved(four, quick, Solved::proved)) << "it claims so";
}

TEST(SummaryTable, CountsAndMeansAreThoseByHand) {
  ReportItem item = item_of_kind("summary");
  item.filter["method"] = {"quick", "slow"};
  set_option(item, "shift", "0");
  const Table table = build_table(item, contest());
  const auto number = [&](const std::string& method, const std::string& value) {
    for (const TableRecord& record : table.records) {
      if (record.key.front() == method && record.value == value) return record.median;
    }
    return -1.0;
  };
  EXPECT_EQ(number("quick", "problems"), 5);
  EXPECT_EQ(number("quick", "complete, proved"), 3);
  EXPECT_EQ(number("quick", "ended without proof"), 1);
  EXPECT_EQ(number("quick", "not ended"), 1);
  EXPECT_EQ(number("quick", "open roots"), 2);
  EXPECT_EQ(number("quick", "false roots"), 1);
  EXPECT_EQ(number("slow", "not ended"), 3);
  EXPECT_DOUBLE_EQ(number("quick", "mean over shared problems"), 1) << "of 0.5 and 2";
  EXPECT_DOUBLE_EQ(number("slow", "mean over shared problems"), 4) << "of 2 and 8";
  const double product = 0.5 * 2 * 3 * 20 * 20;  // three and five count as twice the limit of 10 s
  EXPECT_DOUBLE_EQ(number("quick", "mean over all problems with penalty"), std::pow(product, 0.2));
  EXPECT_TRUE(has(markdown_text(table), "counts as 20 s")) << markdown_text(table);
}

TEST(SummaryTable, BaselinesAndReferencesAreNeverBest) {
  ReportItem item = item_of_kind("summary");
  refer_to(item, "other");
  const std::string text = markdown_text(build_table(item, contest()));
  EXPECT_TRUE(has(text, "| other A (not the same run) | 3 | 2 | 0 | 1 |")) << text;
  EXPECT_TRUE(has(text, "Not the same run: Figures of another program; elsewhere.")) << text;
  for (const char* method : {"| baseline |", "| other A"}) {
    const std::size_t line = text.find(method);
    ASSERT_NE(line, std::string::npos) << text;
    EXPECT_FALSE(has(text.substr(line, text.find('\n', line) - line), "**")) << text;
  }
}

TEST(AgainstTable, ComparesWithTheBetterFigureOverWhatBothSolve) {
  ReportItem item = item_of_kind("against");
  refer_to(item, "other");
  item.filter["method"] = {"quick"};
  set_option(item, "shift", "0");
  const std::string text = markdown_text(build_table(item, contest()));
  EXPECT_TRUE(has(text, "| one | 1 | 0.500 | 0.500 |")) << "other B is the better there\n" << text;
  EXPECT_TRUE(has(text, "| two | timeout | 2 | – |")) << text;
  EXPECT_TRUE(has(text, "| three | 0.250 | partial | – |")) << text;
  EXPECT_TRUE(has(text, "| mean here / mean there |  | 0.500 |  |")) << text;
  EXPECT_TRUE(has(text, "Solved there and not by quick: three.")) << text;
  EXPECT_TRUE(has(text, "Solved by quick and not there: two.")) << text;
  EXPECT_FALSE(has(text, "four")) << "there is no figure of it\n" << text;
}

TEST(AgainstTable, NeedsReferences) {
  EXPECT_TRUE(has(error_text([] { build_table(item_of_kind("against"), contest()); }), "needs references"));
}

TEST(TableKinds, RefuseWhatTheyDoNotTake) {
  ReportItem rows = item_of_kind("summary");
  rows.rows = {"problem"};
  EXPECT_TRUE(has(error_text([&] { check_table(rows); }), "takes no rows, columns and best"));
  ReportItem option = item_of_kind("summary");
  set_option(option, "shfit", "1");
  EXPECT_TRUE(has(error_text([&] { check_table(option); }), "did you mean 'shift'"));
  EXPECT_TRUE(has(error_text([] { check_table(item_of_kind("sumary")); }), "did you mean 'summary'"));
  EXPECT_TRUE(has(error_text([] { check_table(item_of_kind("cells")); }), "needs rows and values"));
}

TEST(References, StandInTablesOfCellsAsFurtherMethods) {
  ReportItem item = sample_item("t", {"problem"}, {"method"}, {"cpu_s"});
  item.filter["method"] = {"quick"};
  item.best = "min";
  refer_to(item, "other");
  const std::string text = markdown_text(build_table(item, contest()));
  EXPECT_TRUE(has(text, "| problem | quick | other A (not the same run) | other B (not the same run) |"))
      << text;
  EXPECT_TRUE(has(text, "Not the same run")) << text;
  EXPECT_FALSE(has(text, "**1**")) << "other programs take no part in the best\n" << text;
}

TEST(References, AreRefusedBesideSeveralValuesOfAnAxisTheyLack) {
  ReportContext context =
      sample_context({sample_row("p/one", "m", 1, 1, "6"), sample_row("p/one", "m", 1, 1, "8")});
  context.references.emplace("other", other_program());
  ReportItem item = sample_item("t", {"problem", "depth"}, {"method"}, {"wall_s"});
  refer_to(item, "other");
  EXPECT_TRUE(has(error_text([&] { build_table(item, context); }), "references have no depth"));
}

TEST(PerformanceProfileFigure, SaysWhatItCountsAndIsAcceptedByGnuplot) {
  ReportItem item = item_of_kind("performance_profile", ReportItem::Form::figure);
  item.values = {"cpu_s", "boxes"};
  item.filter["method"] = {"quick", "slow"};
  const FigureScript figure = draw_figure(item, contest());
  std::string notes;
  for (const std::string& note : figure.notes) notes += note + "\n";
  EXPECT_TRUE(has(notes, "Share of 5 problems")) << notes;
  EXPECT_TRUE(has(notes, "No method solves 2 of them (three, five).")) << notes;
  EXPECT_TRUE(has(figure.data(), "4 40")) << "slow: two of five problems within factor 4\n" << figure.data();
  const TemporaryFolder folder;
  write_figure(figure, "A profile", folder.path(), "profile", {"svg"});
  EXPECT_TRUE(has(read_file(folder.path() / "profile.svg"), "</svg>"));
}

TEST(PerformanceProfileFigure, LeavesOutProblemsWithoutAFigureOfEveryMethod) {
  ReportItem item = item_of_kind("performance_profile", ReportItem::Form::figure);
  item.filter["method"] = {"quick"};
  refer_to(item, "other");
  const FigureScript figure = draw_figure(item, contest());
  std::string notes;
  for (const std::string& note : figure.notes) notes += note + "\n";
  EXPECT_TRUE(has(notes, "Share of 1 problems")) << notes;
  EXPECT_TRUE(has(notes, "4 problems are left out")) << notes;
}

}  // namespace
}  // namespace gcslab
