#include "experiments/reporting/row_table.h"

#include <gtest/gtest.h>

#include "base/atomic_file.h"
#include "base/error.h"
#include "experiments/runner/job_row.h"
#include "unit/reporting/sample_rows.h"

namespace gcslab {
namespace {

Job sample_job(const std::string& method) {
  const std::vector<OptionSpec> depth = {{.name = "depth", .meaning = "", .default_value = std::int64_t{8}}};
  Job job;
  job.experiment = "sample";
  job.task = "cover";
  job.problem = "curves/folium";
  job.problem_hash = "hash";
  job.method = method;
  job.label = method + "!";
  job.parameters = Options(depth, {}, "cover");
  return job;
}

TEST(RowTable, MissingAndDamagedRowsStay) {
  const TemporaryFolder folder;
  const Job good = sample_job("good");
  const Job damaged = sample_job("damaged");
  const Job missing = sample_job("missing");
  JobResult result;
  result.status = Status::complete;
  result.values["kept_cells"] = 7;
  write_file_atomically(folder.path() / (good.id() + ".json"),
                        to_text(make_row(good, result, 1.5, Json::object())));
  write_file_atomically(folder.path() / (damaged.id() + ".json"), "{\"job\": ");
  const RowTable table = load_rows({good, damaged, missing}, {"depth"}, folder.path());
  ASSERT_EQ(table.rows().size(), 3U);
  EXPECT_EQ(table.rows()[0].status, "complete");
  EXPECT_EQ(table.rows()[0].values.at("kept_cells"), 7);
  EXPECT_EQ(table.rows()[0].at("depth"), "8");
  EXPECT_EQ(table.rows()[1].status, kDamaged);
  EXPECT_NE(table.rows()[1].reason.find(damaged.id()), std::string::npos);
  EXPECT_EQ(table.rows()[2].status, kNotRun);
  EXPECT_EQ(table.rows()[2].at("method"), "missing!");
  EXPECT_EQ(table.axes(), (std::vector<std::string>{"problem", "method", "depth", "seed"}));
}

TEST(RowTable, KeysFollowThePlanAxisByAxis) {
  const ReportContext context = sample_context(
      {sample_row("p", "b", 1, 1, "8"), sample_row("p", "b", 1, 1, "6"), sample_row("p", "a", 1, 1, "8")});
  RowPointers rows;
  for (const Row& row : context.rows.rows()) rows.push_back(&row);
  EXPECT_EQ(keys_on(rows, {"depth", "method"}), (std::vector<AxisKey>{{"8", "b"}, {"8", "a"}, {"6", "b"}}));
  EXPECT_EQ(keys_on(rows, {}), std::vector<AxisKey>{{}});
}

TEST(RowTable, EmptySelectionsAreRefused) {
  const ReportContext context = sample_context({sample_row("p", "m", 1, 1)});
  ReportItem item = sample_item("t", {"problem"}, {}, {"kept_cells"});
  item.filter["depth"] = {"9"};
  EXPECT_THROW(select_rows(context.rows, item), InputError);
}

}  // namespace
}  // namespace gcslab
