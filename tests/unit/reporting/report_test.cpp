#include "experiments/reporting/report.h"

#include <gtest/gtest.h>

#include "base/atomic_file.h"
#include "base/error.h"
#include "experiments/reporting/index_page.h"
#include "unit/reporting/sample_rows.h"

namespace gcslab {
namespace {

ReportOptions options_in(const TemporaryFolder& folder) {
  ReportOptions options;
  options.out = folder.path() / "out";
  options.runs = folder.path() / "runs";
  options.reference = folder.path() / "reports";
  return options;
}

std::vector<ReportItem> items() {
  ReportItem table = sample_item("cells", {"problem"}, {"method"}, {"kept_cells"});
  table.caption = "Cells kept";
  ReportItem figure = sample_item("cost", {}, {"method"}, {"wall_s"});
  figure.form = ReportItem::Form::figure;
  figure.kind = "series";
  set_option(figure, "x", "depth");
  return {table, figure};
}

ReportContext context_with(double kept) {
  return sample_context({sample_row("p", "a", kept, 1), sample_row("p", "b", 9, 1),
                         with_outcome(sample_row("p", "c", 0, 0), "crashed", "SIGSEGV")});
}

TEST(Report, AcceptedReportsAgreeWithThemselvesAndChangesAreFound) {
  const TemporaryFolder folder;
  const ReportOptions options = options_in(folder);
  const ReportRecord first = write_report(items(), context_with(5), options);
  EXPECT_EQ(first.verdict.state, Verdict::State::no_reference);
  accept_report(first, context_with(5), options);
  for (const char* name :
       {"cells.md", "cells.tex", "cells.csv", "cost.svg", "cost.pdf", "cost.dat", "cost.gp", "rows.json"}) {
    EXPECT_TRUE(std::filesystem::exists(options.reference / "sample" / name)) << name;
  }
  EXPECT_NE(read_file(options.reference / "README.md").find("](sample/cost.svg)"), std::string::npos);
  EXPECT_EQ(write_report(items(), context_with(5), options).verdict.state, Verdict::State::equal);
  const ReportRecord changed = write_report(items(), context_with(6), options);
  EXPECT_EQ(changed.verdict.state, Verdict::State::different);
  EXPECT_EQ(changed.verdict.lines.front(), "Differs: p, a, depth 8, seed 1: kept_cells was 5, is 6.");
}

TEST(Report, UnrunJobsCannotBecomeTheReference) {
  const TemporaryFolder folder;
  const ReportContext context =
      sample_context({sample_row("p", "a", 5, 1), with_outcome(sample_row("p", "b", 0, 0), kNotRun, "")});
  const ReportRecord record = write_report({items().front()}, context, options_in(folder));
  EXPECT_THROW(accept_report(record, context, options_in(folder)), InputError);
}

TEST(Report, IndexKeepsOtherExperimentsAndNamesOutcomes) {
  const TemporaryFolder folder;
  const ReportOptions options = options_in(folder);
  write_report(items(), context_with(5), options);
  ReportContext other = context_with(7);
  other.experiment = "other";
  other.title = "Another <title>";
  write_report({items().front()}, other, options);
  make_folder(options.out / "broken");
  write_file_atomically(options.out / "broken" / "report.json", "{");
  EXPECT_EQ(write_index(options.out).size(), 1U) << "the broken one is named";
  const std::string page = read_file(options.out / "index.html");
  for (const char* part :
       {"<img src=\"sample/cost.svg\"", "Another &lt;title&gt;", "p, c, depth 8, seed 1: crashed, SIGSEGV",
        "0123abc", "no reference yet", "3 jobs: 2 complete, 1 crashed"}) {
    EXPECT_NE(page.find(part), std::string::npos) << part;
  }
  EXPECT_EQ(page.find("http"), std::string::npos) << "nothing comes from elsewhere";
}

TEST(Report, OldFilesOfARenamedTableGo) {
  const TemporaryFolder folder;
  const ReportOptions options = options_in(folder);
  std::vector<ReportItem> table = {items().front()};
  write_report(table, context_with(5), options);
  table[0].file = "renamed";
  write_report(table, context_with(5), options);
  EXPECT_FALSE(std::filesystem::exists(options.out / "sample" / "cells.md"));
  EXPECT_TRUE(std::filesystem::exists(options.out / "sample" / "renamed.md"));
}

TEST(Report, FormatsCanBeChosen) {
  const TemporaryFolder folder;
  ReportOptions options = options_in(folder);
  options.formats = {"csv", "svg"};
  const ReportRecord record = write_report(items(), context_with(5), options);
  EXPECT_EQ(record.items[0].formats, std::vector<std::string>{"csv"});
  EXPECT_EQ(record.items[1].formats, (std::vector<std::string>{"svg", "dat", "gp"}));
}

TEST(ReportRecord, TextsRoundTrip) {
  ReportRecord record = record_of(context_with(5));
  record.items.push_back({true, "f", "c", {"svg"}, {"note"}, ""});
  record.verdict = {Verdict::State::different, {"line"}};
  EXPECT_EQ(to_text(record_from_text(to_text(record))), to_text(record));
  EXPECT_EQ(count_text(record), "3 jobs: 2 complete, 1 crashed");
}

}  // namespace
}  // namespace gcslab
