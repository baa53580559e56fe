#include "experiments/runner/job_process.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "experiments/runner/experiment_config.h"
#include "experiments/runner/job_plan.h"
#include "experiments/tasks/job_result.h"
#include "selftest_task.h"

namespace gcslab {
namespace {

JobResult run(const std::string& method, const std::string& more = "") {
  const std::string config =
      "experiment: e\ntask: selftest\nproblems: one\nmethods: {name: " + method + "}\n" + more;
  const Job job = plan_jobs(parse_experiment(config, "c.yaml", selftest_catalogue())).front();
  return run_repetitions(SelftestTask(), job);
}

TEST(JobProcess, TimesEveryRepetition) {
  const JobResult result = run("sleep, options: {seconds: 0.02}", "repetitions: 3\n");
  EXPECT_EQ(result.status, Status::complete);
  ASSERT_EQ(result.timings.at("wall_s").size(), 3U);
  EXPECT_EQ(result.timings.at("cpu_s").size(), 3U);
  for (const Json& seconds : result.timings.at("wall_s")) EXPECT_GE(seconds.get<double>(), 0.02);
}

TEST(JobProcess, ExceptionsAreOutcomes) {
  EXPECT_EQ(run("refuse").status, Status::not_applicable);
  EXPECT_EQ(run("refuse").reason, "transcendental terms");
  EXPECT_EQ(run("fail").status, Status::failed);
  EXPECT_EQ(run("fail").reason, "no solution found");
}

TEST(JobProcess, StopsAtTheFirstRepetitionThatDoesNotRunItsCourse) {
  const JobResult result = run("sleep, options: {seconds: 9}", "repetitions: 3\nlimits: {wall_s: 0.05}\n");
  EXPECT_EQ(result.status, Status::budget_exhausted);
  EXPECT_EQ(result.reason, "wall limit of 0.05 s: asked to stop");
  EXPECT_EQ(result.timings.at("wall_s").size(), 1U);
}

TEST(JobProcess, AnAnswerThatComesTooLateIsNoAnswer) {
  const JobResult result =
      run("sleep, options: {seconds: 0.1, heeds_stop: false}", "limits: {wall_s: 0.05}\n");
  EXPECT_EQ(result.status, Status::budget_exhausted);
  EXPECT_EQ(result.reason, "wall limit of 0.05 s");
}

TEST(JobProcess, ProcessorTimeIsLimitedToo) {
  const JobResult result = run("spin", "limits: {cpu_s: 0.05}\n");
  EXPECT_EQ(result.status, Status::budget_exhausted);
  EXPECT_EQ(result.reason, "CPU limit of 0.05 s: asked to stop");
}

TEST(JobProcess, RepetitionsThatDifferAreAFailure) {
  const JobResult result = run("vary", "repetitions: 2\n");
  EXPECT_EQ(result.status, Status::failed);
  EXPECT_NE(result.reason.find("repetitions differ: 'answer'"), std::string::npos) << result.reason;
}

TEST(JobProcess, AValueThatIsNotDeclaredIsAFaultOfTheProgram) {
  const JobResult result = run("undeclared");
  EXPECT_EQ(result.status, Status::failed);
  EXPECT_NE(result.reason.find("'surprise'"), std::string::npos) << result.reason;
}

}  // namespace
}  // namespace gcslab
