// Every job ends as a row, whatever becomes of its process.

#include "run_program.h"

namespace gcslab {
namespace {

TEST_F(RunTest, EveryEndOfAJobIsARowWithItsName) {
  const Ended ended = run(config(R"(problems: one
repetitions: 2
limits: {wall_s: 0.3, cpu_s: 0.25, memory_mb: 300}
methods:
  - {name: succeed}
  - {name: refuse}
  - {name: fail}
  - {label: segv, name: die}
  - {label: abort, name: die, options: {signal: abort}}
  - {label: exits, name: end_process, options: {code: 3, words: I give up}}
  - {label: exits without result, name: end_process, options: {code: 0, words: all well}}
  - {label: asleep, name: sleep, options: {seconds: 60}}
  - {label: fast asleep, name: sleep, options: {seconds: 60, heeds_stop: false}}
  - {label: busy, name: spin, options: {seconds: 60}}
  - {label: very busy, name: spin, options: {seconds: 60, heeds_stop: false}}
  - {label: growing, name: allocate, options: {block_mb: 20, blocks: 500}}
  - {label: huge, name: allocate, options: {block_mb: 20000}}
)"),
                          {"--jobs", "6"});
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  const auto rows = rows_by_label();
  const auto expect = [&](const std::string& label, Status status, const std::string& reason) {
    ASSERT_TRUE(rows.contains(label)) << label;
    EXPECT_EQ(name_of(rows.at(label).result.status), name_of(status)) << label;
    EXPECT_TRUE(rows.at(label).result.reason.starts_with(reason))
        << label << ": " << rows.at(label).result.reason;
  };
  expect("succeed", Status::complete, "");
  expect("refuse", Status::not_applicable, "transcendental terms");
  expect("fail", Status::failed, "no solution found");
  expect("segv", Status::crashed, "SIGSEGV");
  expect("abort", Status::crashed, "SIGABRT: about to die");
  expect("exits", Status::failed, "exit code 3: I give up");
  expect("exits without result", Status::failed, "the job's process ended without a result: all well");
  expect("asleep", Status::budget_exhausted, "wall limit of 0.3 s: asked to stop");
  expect("fast asleep", Status::budget_exhausted, "wall limit of 0.3 s, stopped by force");
  // On a machine that is loaded, elapsed time may run out before processor time does.
  expect("busy", Status::budget_exhausted, "");
  expect("very busy", Status::budget_exhausted, "");
  expect("growing", Status::out_of_memory, "memory limit of 300 MB");
  expect("huge", Status::out_of_memory, "memory limit of 300 MB");
  EXPECT_NE(ended.out.find("13 run now, 1 complete, 4 budget_exhausted, 1 not_applicable, 3 failed, 2 "
                           "out_of_memory, 2 crashed"),
            std::string::npos)
      << ended.out;
  EXPECT_EQ(processes_alive(), 0U);
  EXPECT_EQ(read_file(runs() / "e/experiment.yaml"), read_file(folder_ / "config.yaml"));
  EXPECT_FALSE(fs::exists(runs() / "e/exchange"));
}

TEST_F(RunTest, ProcessorTimeIsLimitedByForceToo) {
  const Ended ended =
      run(config("problems: one\nlimits: {wall_s: 50, cpu_s: 0.1}\n"
                 "methods: {name: spin, options: {seconds: 60, heeds_stop: false}}\n"));
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_EQ(rows_by_label().at("spin").result.reason, "CPU limit of 0.1 s, stopped by force");
}

TEST_F(RunTest, ARowSaysWhoMadeIt) {
  run(config("problems: one\nmethods: {name: succeed}\nseeds: 7\nrepetitions: 3\n"));
  const JobRow row = rows_by_label().at("succeed");
  for (const char* key : {"commit", "dirty", "compiler", "flags", "cpu", "libraries", "seed", "started"}) {
    EXPECT_TRUE(row.provenance.contains(key)) << key;
  }
  EXPECT_EQ(row.provenance.at("seed"), 7);
  EXPECT_EQ(row.result.timings.at("wall_s").size(), 3U);
  EXPECT_GT(row.peak_rss_mb, 0);
}

TEST_F(RunTest, ARowFileCanBeAskedAgainByHand) {
  run(config("problems: one\nmethods: {name: succeed}\n"));
  const std::string row = (jobs() / row_texts().begin()->first).string();
  const std::string answer = (folder_ / "answer.json").string();
  EXPECT_EQ(RunningProgram(folder_, {"job", row, answer}).wait().exit_code, 0);
  EXPECT_EQ(result_from_json(Json::parse(read_file(answer))).values.at("answer"), 42);
}

TEST_F(RunTest, BadInputIsOneLineAndExitCodeTwo) {
  const Ended ended = run(config("problems: one\nmethods: {name: sucseed}\n"));
  EXPECT_EQ(ended.exit_code, 2);
  EXPECT_NE(ended.err.find("config.yaml:4: unknown method of selftest 'sucseed' (did you mean 'succeed'?)"),
            std::string::npos)
      << ended.err;
  EXPECT_EQ(std::count(ended.err.begin(), ended.err.end(), '\n'), 1);
  EXPECT_FALSE(fs::exists(runs())) << "nothing is made before the config is right";
  EXPECT_EQ(run(config("problems: one\nmethods: {name: succeed}\n"), {"--shard", "3/2"}).exit_code, 2);
  EXPECT_EQ(run("/no/such/file.yaml").exit_code, 2);
}

TEST_F(RunTest, TwoConfigsOfOneNameAreRefused) {
  const std::string file = config("problems: one\nmethods: {name: succeed}\n");
  EXPECT_EQ(run(file, {file}).exit_code, 2);
}

}  // namespace
}  // namespace gcslab
