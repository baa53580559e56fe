// What is done is not done again, and nothing that is done is lost.

#include <algorithm>
#include <sys/resource.h>

#include "base/random.h"
#include "run_program.h"

namespace gcslab {
namespace {

constexpr const char* kQuick = "problems: suite:all\nmethods: [{name: succeed}, {name: fail}]\n";
constexpr const char* kSlow =
    "problems: [one, two, three, four, five, six, seven, eight, nine]\nmethods: {name: sleep, options: "
    "{seconds: 0.04}}\n";
constexpr const char* kEndless =
    "problems: suite:all\nmethods: [{name: succeed}, {name: sleep, options: {seconds: 50}}]\n";

std::size_t count(const std::string& text, const std::string& word) {
  std::size_t times = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++times;
  return times;
}

TEST_F(RunTest, AJobIsRunOnce) {
  EXPECT_NE(run(config(kQuick)).out.find("6 run now"), std::string::npos);
  const auto rows = row_texts();
  const Ended again = run(config(kQuick));
  EXPECT_EQ(again.exit_code, 0);
  EXPECT_NE(again.out.find("e: 6 jobs: 6 cached, 0 stale, 0 fresh"), std::string::npos) << again.out;
  EXPECT_NE(again.out.find("0 run now, 3 complete, 3 failed"), std::string::npos) << again.out;
  EXPECT_EQ(row_texts(), rows);
}

TEST_F(RunTest, FreshRunsEveryJobAgain) {
  run(config(kQuick));
  const Ended again = run(config(kQuick), {"--fresh"});
  EXPECT_NE(again.out.find("6 run now, 3 complete, 3 failed"), std::string::npos) << again.out;
}

TEST_F(RunTest, DryRunShowsThePlanAndMakesNothing) {
  const Ended ended = run(config(kQuick), {"--dry-run"});
  EXPECT_EQ(ended.exit_code, 0);
  EXPECT_EQ(count(ended.out, "fresh  "), 6U) << ended.out;
  EXPECT_FALSE(fs::exists(runs()));
}

TEST_F(RunTest, ExplainSaysWhyARowStandsOrFalls) {
  run(config(kQuick));
  EXPECT_EQ(count(run(config(kQuick), {"--dry-run", "--explain"}).out, ": complete, made 20"), 3U);
  const Ended edited =
      run(config(kQuick), {"--dry-run", "--explain"}, [] { setenv("SELFTEST_EDITION", "second", 1); });
  EXPECT_EQ(count(edited.out, "problem two has changed"), 2U) << edited.out;
  const Ended other =
      run(config("problems: one\nmethods: {name: succeed, options: {answer: 7}}\n"), {"--explain"});
  EXPECT_NE(other.out.find(
                "stale  one, succeed, cell_size=0.5, depth=8, split=all, seed=1: option answer was 42, is 7"),
            std::string::npos)
      << other.out;
}

TEST_F(RunTest, ShardsMakeTheWholeTogether) {
  EXPECT_NE(run(config(kQuick), {"--shard", "1/4"}).out.find("e: 2 jobs in shard 1/4"), std::string::npos);
  for (const char* shard : {"2/4", "3/4", "4/4"})
    EXPECT_EQ(run(config(kQuick), {"--shard", shard}).exit_code, 0);
  EXPECT_NE(run(config(kQuick)).out.find("6 cached"), std::string::npos);
}

TEST_F(RunTest, ADamagedRowIsMadeAgain) {
  run(config(kQuick));
  fs::resize_file(jobs() / row_texts().begin()->first, 20);
  EXPECT_NE(run(config(kQuick)).out.find("5 cached, 1 stale"), std::string::npos);
  EXPECT_EQ(row_texts().size(), 6U);
}

TEST_F(RunTest, KilledAtAnyMomentItLosesOnlyTheJobsInFlight) {
  Random random(1, "moments at which the runner is killed");
  std::map<std::string, std::string> rows;
  int kills = 0;
  while (rows.size() < 9 && kills < 40) {
    RunningProgram program(folder_, run_arguments(config(kSlow), {"--jobs", "2"}));
    pause_ms(static_cast<int>(random.integer(5, 150)));
    program.send(SIGKILL);
    program.wait();
    ++kills;
    EXPECT_TRUE(eventually([&] { return processes_alive() == 0; })) << "a job outlived the runner";
    const auto now = row_texts();
    for (const auto& [file, text] : rows) EXPECT_EQ(now.at(file), text) << "a row was lost or made twice";
    rows = now;
  }
  EXPECT_GE(kills, 2);
  const Ended last = run(config(kSlow));
  EXPECT_EQ(last.exit_code, 0) << last.err;
  EXPECT_EQ(row_texts().size(), 9U);
  for (const auto& [label, row] : rows_by_label()) EXPECT_EQ(row.result.status, Status::complete);
}

TEST_F(RunTest, CtrlCKeepsWhatIsDoneAndSaysHowToGoOn) {
  for (const int signal : {SIGINT, SIGTERM}) {
    RunningProgram program(folder_, run_arguments(config(kEndless), {"--jobs", "6"}));
    EXPECT_TRUE(eventually([&] { return row_texts().size() == 3 && processes_alive() == 4; }));
    program.send(signal);
    const Ended ended = program.wait();
    EXPECT_EQ(ended.exit_code, 3);
    EXPECT_NE(ended.err.find("interrupted: 3 of 6 jobs have a row; the same command goes on from there"),
              std::string::npos)
        << ended.err;
    EXPECT_EQ(processes_alive(), 0U);
    EXPECT_EQ(row_texts().size(), 3U);
  }
}

TEST_F(RunTest, OneFolderTakesOneRunAtATime) {
  RunningProgram first(folder_, run_arguments(config(kEndless)));
  EXPECT_TRUE(eventually([&] { return !row_texts().empty(); }));
  fs::create_directory(folder_ / "second");
  const Ended second = RunningProgram(folder_ / "second", run_arguments(config(kEndless))).wait();
  EXPECT_EQ(second.exit_code, 2);
  EXPECT_NE(second.err.find("another run writes to " + (runs() / "e").string()), std::string::npos)
      << second.err;
  EXPECT_EQ(
      RunningProgram(folder_ / "second", run_arguments(config(kEndless), {"--dry-run"})).wait().exit_code, 0);
}

// ---- places that cannot be written
// -----------------------------------------------------------------------------------

void expect_one_clear_error(const Ended& ended, const std::string& words) {
  EXPECT_EQ(ended.exit_code, 2);
  EXPECT_NE(ended.err.find(words), std::string::npos) << ended.err;
  EXPECT_EQ(count(ended.err, "gcslab: "), 1U) << ended.err;
}

TEST_F(RunTest, AFullDiskIsOneErrorAndEarlierRowsStand) {
  const std::string file = config(
      "problems: one\nmethods: [{name: succeed}, {name: large, options: {bytes: 30000}}, {name: fail}]\n");
  const Ended ended = run(file, {}, [] {
    const rlimit limit{8000, 8000};
    setrlimit(RLIMIT_FSIZE, &limit);
  });
  expect_one_clear_error(ended, "File too large");
  EXPECT_EQ(row_texts().size(), 1U);
  EXPECT_EQ(run(file).exit_code, 0) << "with room again, it goes on";
  EXPECT_EQ(row_texts().size(), 3U);
}

TEST_F(RunTest, AFileWhereTheFolderShouldBeIsOneError) {
  write_file_atomically(runs(), "no folder");
  expect_one_clear_error(run(config(kQuick)), "cannot make folder");
  expect_one_clear_error(RunningProgram(folder_, {"run", config(kQuick), "--out", "/dev/full"}).wait(),
                         "cannot make folder /dev/full/e/jobs");
}

/// Root may write everywhere: be somebody else.
void become_ordinary_user() {
  constexpr uid_t kNobody = 65534;
  if (getuid() == 0 && (setgid(kNobody) != 0 || setuid(kNobody) != 0)) _exit(125);
}

TEST_F(RunTest, AFolderThatIsNotOursIsOneError) {
  const std::string file = config(kQuick);
  fs::create_directory(runs());
  fs::permissions(runs(), fs::perms::owner_read | fs::perms::owner_exec | fs::perms::others_read |
                              fs::perms::others_exec);
  const Ended ended = run(file, {}, become_ordinary_user);
  if (ended.exit_code == 126) GTEST_SKIP() << "the program lies where an ordinary user cannot reach it";
  expect_one_clear_error(ended, "Permission denied");
}

TEST_F(RunTest, RowsThatCannotBeReplacedAreOneError) {
  const std::string file = config(kQuick);
  run(file);
  const auto rows = row_texts();
  fs::permissions(jobs(), fs::perms::owner_read | fs::perms::owner_exec | fs::perms::others_read |
                              fs::perms::others_exec);
  fs::permissions(runs() / "e", fs::perms::all);
  fs::permissions(runs() / "e/lock", fs::perms::all);
  const Ended ended = run(file, {"--fresh"}, become_ordinary_user);
  if (ended.exit_code == 126) GTEST_SKIP() << "the program lies where an ordinary user cannot reach it";
  expect_one_clear_error(ended, "Permission denied");
  EXPECT_EQ(row_texts(), rows);
  fs::permissions(jobs(), fs::perms::all);
}

}  // namespace
}  // namespace gcslab
