#include "experiments/runner/progress.h"

#include <gtest/gtest.h>
#include <sstream>

#include "experiments/process/child_process.h"
#include "experiments/runner/supervisor.h"

namespace gcslab {
namespace {

FinishedJob finished(Status status, const std::string& reason) {
  FinishedJob job;
  job.job.problem = "one";
  job.job.label = "sleep";
  job.result.status = status;
  job.result.reason = reason;
  job.wall_s = 1.5;
  return job;
}

TEST(Progress, DurationsReadWell) {
  EXPECT_EQ(duration_text(0.2), "0 s");
  EXPECT_EQ(duration_text(59.4), "59 s");
  EXPECT_EQ(duration_text(59.6), "1 min 00 s");
  EXPECT_EQ(duration_text(245), "4 min 05 s");
  EXPECT_EQ(duration_text(7620), "2 h 07 min");
}

TEST(Progress, OffATerminalEveryJobIsALine) {
  std::ostringstream out;
  Progress progress(out, false, "e", 2);
  progress.tick(1);
  progress.finished(finished(Status::complete, ""));
  progress.finished(finished(Status::crashed, "SIGSEGV"));
  EXPECT_EQ(out.str(),
            "[1/2] one, sleep, seed=1: complete in 1.50 s\n"
            "[2/2] one, sleep, seed=1: crashed in 1.50 s (SIGSEGV)\n");
}

TEST(Progress, OnATerminalOneLineIsRewrittenAndOnlyTroubleStays) {
  std::ostringstream out;
  {
    Progress progress(out, true, "e", 2);
    progress.tick(1);
    progress.finished(finished(Status::complete, ""));
    EXPECT_EQ(out.str().find('\n'), std::string::npos);
    progress.finished(finished(Status::crashed, "SIGSEGV"));
  }
  EXPECT_NE(out.str().find("e: 0 of 2 jobs, 1 running"), std::string::npos);
  EXPECT_NE(out.str().find("crashed in 1.50 s (SIGSEGV)\n"), std::string::npos);
  EXPECT_TRUE(out.str().ends_with("\r\033[K")) << "the line is left clean";
}

TEST(ChildProcess, TheLastLineIsTheLastThatSaysSomething) {
  EXPECT_EQ(last_line(""), "");
  EXPECT_EQ(last_line("\n \n"), "");
  EXPECT_EQ(last_line("one"), "one");
  EXPECT_EQ(last_line("one\ntwo\n\n"), "two");
}

}  // namespace
}  // namespace gcslab
