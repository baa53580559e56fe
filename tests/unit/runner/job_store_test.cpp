#include "experiments/runner/job_store.h"

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <unistd.h>

#include "base/error.h"
#include "experiments/runner/experiment_config.h"
#include "experiments/runner/job_plan.h"
#include "selftest_task.h"

namespace gcslab {
namespace {

namespace fs = std::filesystem;

class JobStoreTest : public testing::Test {
 protected:
  JobStoreTest() : folder_(fs::temp_directory_path() / ("gcslab-job-store-" + std::to_string(getpid()))) {
    fs::remove_all(folder_);
  }
  ~JobStoreTest() override { fs::remove_all(folder_); }

  static Job job(const std::string& more = "", const std::string& options = "{}") {
    const std::string config =
        "experiment: e\ntask: selftest\nproblems: one\nmethods: {name: succeed, options: " + options + "}\n" +
        more;
    return plan_jobs(parse_experiment(config, "c.yaml", selftest_catalogue())).front();
  }

  void save(const Job& job, Status status, double wall_s = 0.5) {
    JobResult result;
    result.status = status;
    result.timings = {{"wall_s", {wall_s}}, {"cpu_s", {wall_s}}};
    JobStore(folder_).save(make_row(job, result, 100, {{"commit", "0123456789abcdef"}, {"started", "then"}}));
  }

  /// "stale: why", as --explain would say.
  std::string explain(const Job& job) {
    const JobState state = JobStore(folder_).state(job);
    return std::string(name_of(state.kind)) + ": " + state.reason;
  }

  fs::path folder_;
};

TEST_F(JobStoreTest, AJobWithoutRowIsFresh) {
  EXPECT_EQ(explain(job()), "fresh: never run");
  EXPECT_FALSE(fs::exists(folder_)) << "looking makes nothing";
}

TEST_F(JobStoreTest, ARowStandsWhateverItsOutcome) {
  for (const Status status :
       {Status::complete, Status::partial, Status::budget_exhausted, Status::not_applicable, Status::failed,
        Status::out_of_memory, Status::crashed}) {
    save(job(), status);
    EXPECT_EQ(explain(job()),
              "cached: " + std::string(name_of(status)) + ", made then by commit 0123456789ab");
    EXPECT_EQ(JobStore(folder_).state(job()).status, status);
  }
}

TEST_F(JobStoreTest, ExplainsWhichPartOfTheQuestionChanged) {
  save(job(), Status::complete);
  EXPECT_EQ(explain(job("", "{arithmetic: slow}")), "stale: option arithmetic was fast, is slow");
  Job edited = job();
  edited.problem_hash = "edited";
  EXPECT_EQ(explain(edited), "stale: problem one has changed");
  Job newer = job();
  newer.method_version = 2;
  EXPECT_EQ(explain(newer), "stale: version of method succeed was 1, is 2");
  EXPECT_EQ(explain(job("parameters: {depth: 3}\n")), "fresh: never run");
  EXPECT_EQ(explain(job("seeds: 2\n")), "fresh: never run");
}

TEST_F(JobStoreTest, AChangeThatIsTakenBackFindsItsRowAgain) {
  save(job(), Status::complete);
  save(job("", "{arithmetic: slow}"), Status::complete);
  EXPECT_TRUE(explain(job()).starts_with("cached"));
}

TEST_F(JobStoreTest, MoreRepetitionsAskAgainFewerDoNot) {
  save(job("repetitions: 3\n"), Status::complete);
  EXPECT_EQ(explain(job("repetitions: 5\n")), "stale: has 3 of 5 repetitions");
  EXPECT_TRUE(explain(job("repetitions: 2\n")).starts_with("cached"));
  save(job("repetitions: 3\n"), Status::failed);
  EXPECT_TRUE(explain(job("repetitions: 5\n")).starts_with("cached"));
}

TEST_F(JobStoreTest, AnOutcomeThatHingesOnALimitFallsWithIt) {
  save(job(), Status::budget_exhausted);
  EXPECT_TRUE(
      explain(job("limits: {wall_s: 120}\n")).starts_with("stale: ended budget_exhausted under the limits"));
  save(job(), Status::complete, 5.0);
  EXPECT_TRUE(explain(job("limits: {wall_s: 120}\n")).starts_with("cached"));
  EXPECT_TRUE(explain(job("limits: {wall_s: 10}\n")).starts_with("cached"));
  EXPECT_EQ(explain(job("limits: {wall_s: 2}\n")), "stale: took 5 s, the wall limit is now 2 s");
  EXPECT_EQ(explain(job("limits: {cpu_s: 2}\n")), "stale: took 5 s CPU, the limit is now 2 s");
  EXPECT_EQ(explain(job("limits: {memory_mb: 50}\n")), "stale: took 100 MB, the memory limit is now 50 MB");
}

TEST_F(JobStoreTest, ADamagedRowIsNamedAndMadeAgain) {
  save(job(), Status::complete);
  const fs::path file = JobStore(folder_).file_of(job().id());
  fs::resize_file(file, fs::file_size(file) / 2);
  EXPECT_NE(explain(job()).find(file.string() + " is damaged"), std::string::npos) << explain(job());
  EXPECT_TRUE(explain(job()).starts_with("stale"));
}

TEST_F(JobStoreTest, ARowUnderAnotherNameIsDamaged) {
  save(job(), Status::complete);
  const JobStore store(folder_);
  fs::copy_file(store.file_of(job().id()), store.file_of(job("seeds: 2\n").id()));
  EXPECT_NE(explain(job("seeds: 2\n")).find("damaged"), std::string::npos);
}

}  // namespace
}  // namespace gcslab
