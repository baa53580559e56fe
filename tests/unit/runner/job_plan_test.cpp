#include "experiments/runner/job_plan.h"

#include <functional>
#include <gtest/gtest.h>
#include <set>

#include "base/error.h"
#include "experiments/runner/experiment_config.h"
#include "experiments/tasks/catalogue.h"
#include "selftest_task.h"

namespace gcslab {
namespace {

constexpr const char* kConfig = R"(experiment: e
task: selftest
problems: [two, one]
methods: [{name: sleep}, {name: succeed}]
parameters: {split: [alternate, all], depth: [3, 2]}
seeds: [5, 4]
)";

std::vector<Job> plan(const std::string& text, const Catalogue& catalogue = selftest_catalogue()) {
  return plan_jobs(parse_experiment(text, "c.yaml", catalogue));
}

Job one_job(const std::string& options = "{}", const std::string& more = "") {
  return plan("experiment: e\ntask: selftest\nproblems: one\nmethods: {name: succeed, options: " + options +
              "}\n" + more)
      .front();
}

TEST(JobPlan, RunsThroughProblemsMethodsParametersAndSeedsInTheOrderOfTheConfig) {
  const std::vector<Job> jobs = plan(kConfig);
  ASSERT_EQ(jobs.size(), 32U);
  EXPECT_EQ(jobs[0].place(), "two, sleep, cell_size=0.5, depth=3, split=alternate, seed=5");
  EXPECT_EQ(jobs[1].place(), "two, sleep, cell_size=0.5, depth=3, split=alternate, seed=4");
  EXPECT_EQ(jobs[2].place(), "two, sleep, cell_size=0.5, depth=2, split=alternate, seed=5");
  EXPECT_EQ(jobs[4].place(), "two, sleep, cell_size=0.5, depth=3, split=all, seed=5");
  EXPECT_EQ(jobs[8].place(), "two, succeed, cell_size=0.5, depth=3, split=alternate, seed=5");
  EXPECT_EQ(jobs[31].place(), "one, succeed, cell_size=0.5, depth=2, split=all, seed=4");
}

TEST(JobPlan, EveryJobHasItsOwnName) {
  std::set<std::string> ids;
  for (const Job& job : plan(kConfig)) EXPECT_TRUE(ids.insert(job.id()).second);
}

TEST(JobPlan, ShardsAreDisjointAndTogetherThePlan) {
  const std::vector<Job> jobs = plan(kConfig);
  for (const std::size_t count : {1U, 2U, 3U, 7U, 32U, 40U}) {
    std::multiset<std::string> ids;
    for (std::size_t index = 1; index <= count; ++index) {
      for (const Job& job : jobs_of_shard(jobs, {index, count})) ids.insert(job.id());
    }
    std::multiset<std::string> all;
    for (const Job& job : jobs) all.insert(job.id());
    EXPECT_EQ(ids, all) << count;
  }
}

TEST(JobPlan, ShardsAreReadStrictly) {
  EXPECT_EQ(Shard::parse("2/5").index, 2U);
  EXPECT_EQ(Shard::parse("2/5").count, 5U);
  for (const char* wrong : {"", "1", "/", "0/3", "4/3", "1/0", "1/2/3", "a/b", "1/2x", "-1/2", "1 /2"}) {
    EXPECT_THROW(Shard::parse(wrong), InputError) << wrong;
  }
}

TEST(JobPlan, ProblemsOfEqualContentAreRefused) {
  Catalogue catalogue = selftest_catalogue();
  catalogue.problems.content_hash = [](const std::string&) { return "same"; };
  EXPECT_THROW(plan(kConfig, catalogue), InputError);
}

// A committed name: changing how jobs are named makes every row that exists useless, which must not happen
// unnoticed.
TEST(JobId, IsTheSameOnEveryMachineAndInEveryVersion) {
  EXPECT_EQ(one_job().id(), "11abc45423a77454eea55a1d79d42e71");
}

TEST(JobId, DependsOnAllThatTheAnswerMayDependOn) {
  const Job job = one_job();
  const std::vector<std::function<void(Job&)>> changes = {
      [](Job& j) { j.problem_hash = "other"; },
      [](Job& j) { j.task = "other"; },
      [](Job& j) { j.method = "other"; },
      [](Job& j) { j.method_version = 2; },
      [](Job& j) { j.seed = 2; },
      [](Job& j) { j.options = one_job("{answer: 7}").options; },
      [](Job& j) { j.options = one_job("{negative: true}").options; },
      [](Job& j) { j.options = one_job("{scale: 1.0000000000000002}").options; },
      [](Job& j) { j.parameters = one_job("{}", "parameters: {depth: 7}\n").parameters; },
  };
  std::set<std::string> ids = {job.id()};
  for (const auto& change : changes) {
    Job changed = job;
    change(changed);
    EXPECT_TRUE(ids.insert(changed.id()).second) << ids.size();
  }
}

TEST(JobId, DependsOnNothingElse) {
  const std::string id = one_job().id();
  EXPECT_EQ(one_job("{answer: 42, scale: 1}", "parameters: {depth: 8}\n").id(), id) << "defaults written out";
  EXPECT_EQ(one_job("{}", "repetitions: 9\nlimits: {wall_s: 1}\n").id(), id);
  Job job = one_job();
  job.experiment = job.label = job.problem = "other";
  EXPECT_EQ(job.id(), id);
}

}  // namespace
}  // namespace gcslab
