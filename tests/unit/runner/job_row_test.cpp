#include "experiments/runner/job_row.h"

#include <gtest/gtest.h>
#include <limits>

#include "base/error.h"
#include "experiments/runner/experiment_config.h"
#include "experiments/runner/job_plan.h"
#include "selftest_task.h"

namespace gcslab {
namespace {

Job sample_job() {
  const char* config =
      "experiment: e\ntask: selftest\nproblems: one\nmethods: {name: succeed, options: {scale: 0.1}}\n";
  return plan_jobs(parse_experiment(config, "c.yaml", selftest_catalogue())).front();
}

JobRow sample_row() {
  JobResult result;
  result.status = Status::partial;
  result.reason = "two boxes left";
  result.values = {{"zeta", 3}, {"alpha", "1/3"}};
  result.timings = {{"wall_s", {0.5, 0.25}}};
  result.artifact = {{"cells", {1, 2}}};
  return make_row(sample_job(), result, 12.5, {{"commit", "abc"}});
}

TEST(JobRow, ComesBackAsItWasWritten) {
  const JobRow row = sample_row();
  const JobRow back = row_from_text(to_text(row));
  EXPECT_EQ(to_text(back), to_text(row));
  EXPECT_EQ(back.result.status, Status::partial);
  EXPECT_EQ(back.result.values.begin().key(), "zeta") << "the task's order is kept";
  EXPECT_EQ(back.limits, row.limits) << "an infinite limit survives";
}

TEST(JobRow, HasTheKeysThatReportsRelyOn) {
  const Json json = Json::parse(to_text(sample_row()));
  for (const char* key :
       {"job",     "experiment",     "task",       "problem",  "problem_hash", "method",    "label",
        "options", "method_version", "parameters", "seed",     "repetitions",  "limits",    "status",
        "reason",  "values",         "timings",    "artifact", "peak_rss_mb",  "provenance"}) {
    EXPECT_TRUE(json.contains(key)) << key;
  }
  EXPECT_EQ(json.at("options").dump(), R"({"answer":42,"arithmetic":"fast","negative":false,"scale":0.1})");
}

TEST(JobRow, NumbersThatJsonCannotHoldBecomeTexts) {
  JobResult result;
  result.values = {{"a", std::numeric_limits<double>::infinity()},
                   {"b", {std::numeric_limits<double>::quiet_NaN()}}};
  EXPECT_EQ(result_json(result).at("values").dump(), R"({"a":"inf","b":["nan"]})");
}

TEST(JobRow, BytesThatAreNoTextDoNotCostTheRow) {
  JobRow row = sample_row();
  row.result.reason = "bad \xff byte";
  EXPECT_NE(row_from_text(to_text(row)).result.reason.find("byte"), std::string::npos);
}

TEST(JobRow, DamagedTextIsRefused) {
  const std::string text = to_text(sample_row());
  for (std::size_t length = 0; length + 2 < text.size(); length += 7) {
    EXPECT_THROW(row_from_text(text.substr(0, length)), InputError) << length;
  }
  EXPECT_THROW(row_from_text("{}"), InputError);
  EXPECT_THROW(row_from_text("[1, 2]"), InputError);
  EXPECT_THROW(row_from_text(R"({"job": 5})"), InputError);
}

TEST(JobRow, ARowIsAQuestionThatCanBeAskedAgain) {
  const Job job = job_from_text(to_text(sample_row()), selftest_catalogue().tasks);
  EXPECT_EQ(job.id(), sample_job().id());
  EXPECT_EQ(job.options.values(), sample_job().options.values());
  EXPECT_EQ(job.limits, sample_job().limits);
}

TEST(JobRow, AQuestionOfAnotherVersionIsRefused) {
  JobRow row = sample_row();
  row.problem_hash = "edited";
  EXPECT_THROW(job_from_text(to_text(row), selftest_catalogue().tasks), InputError);
}

}  // namespace
}  // namespace gcslab
