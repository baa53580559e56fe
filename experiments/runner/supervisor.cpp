#include "experiments/runner/supervisor.h"

#include <algorithm>
#include <csignal>
#include <cstring>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <optional>

#include "base/atomic_file.h"
#include "base/error.h"
#include "experiments/provenance.h"
#include "experiments/runner/job_process.h"
#include "experiments/runner/job_row.h"

namespace gcslab {
namespace {

namespace fs = std::filesystem;

/// The child stops itself softly at the limits of each repetition; this is where patience ends.
Limits hard_limits(const Job& job) {
  constexpr double kGrace_s = 2.0;
  Limits hard = job.limits;
  hard.wall_s = job.limits.wall_s * job.repetitions + kGrace_s;
  hard.cpu_s = job.limits.cpu_s * job.repetitions + kGrace_s;
  return hard;
}

JobResult outcome(Status status, std::string reason) {
  JobResult result;
  result.status = status;
  result.reason = std::move(reason);
  return result;
}

std::string signal_name(int signal) {
  const char* name = sigabbrev_np(signal);
  return name == nullptr ? fmt::format("signal {}", signal) : fmt::format("SIG{}", name);
}

std::string with_last_line(const std::string& reason, const ChildEnd& end) {
  const std::string line = last_line(end.stderr_tail);
  return line.empty() ? reason : reason + ": " + line;
}

/// GMP and uncaught std::bad_alloc abort the process with a message.
bool aborted_for_memory(const ChildEnd& end) {
  const auto says = [&](const char* words) { return end.stderr_tail.find(words) != std::string::npos; };
  return end.signal == SIGABRT && (says("bad_alloc") || says("annot allocate memory"));
}

JobResult outcome_of_limit(const ChildEnd& end, const Limits& limits) {
  switch (end.stopped_by) {
    case StoppedBy::memory_limit:
      return outcome(Status::out_of_memory, memory_limit_text(limits));
    case StoppedBy::cpu_limit:
      return outcome(Status::budget_exhausted, cpu_limit_text(limits) + ", stopped by force");
    default:
      return outcome(Status::budget_exhausted, wall_limit_text(limits) + ", stopped by force");
  }
}

JobResult outcome_of_signal(const ChildEnd& end, const Limits& limits) {
  if (end.signal == SIGXCPU)
    return outcome(Status::budget_exhausted, cpu_limit_text(limits) + ", stopped by force");
  if (aborted_for_memory(end)) return outcome(Status::out_of_memory, memory_limit_text(limits));
  const std::string name =
      signal_name(end.signal) + (end.signal == SIGKILL ? " from outside the runner" : "");
  return outcome(Status::crashed, with_last_line(name, end));
}

std::optional<Json> read_answer(const fs::path& file) {
  try {
    return Json::parse(read_file(file));
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

std::string exit_text(const ChildEnd& end) {
  if (end.exit_code == 0) return with_last_line("the job's process ended without a result", end);
  return with_last_line(fmt::format("exit code {}", end.exit_code), end);
}

}  // namespace

void Supervisor::start(const Job& job) {
  const std::string id = job.id();
  Child child{job, exchange_ / (id + ".question.json"), exchange_ / (id + ".answer.json"), utc_now(),
              nullptr};
  write_file_atomically(child.question, map_text(question_json(job)));
  const std::vector<std::string> arguments = {"job", child.question.string(), child.answer.string()};
  child.process = std::make_unique<ChildProcess>(arguments, hard_limits(job));
  children_.push_back(std::move(child));
}

FinishedJob Supervisor::finish(const Child& child) {
  const ChildEnd& end = child.process->end();
  FinishedJob finished{child.job, {}, end.wall_s, end.peak_rss_mb, child.started};
  if (end.exit_code == kCannotGoOn) throw InputError(last_line(end.stderr_tail));
  if (end.stopped_by != StoppedBy::nothing) {
    finished.result = outcome_of_limit(end, child.job.limits);
  } else if (end.signal != 0) {
    finished.result = outcome_of_signal(end, child.job.limits);
  } else if (const auto answer = read_answer(child.answer); answer && end.exit_code == 0) {
    finished.result = result_from_json(*answer);
    finished.peak_rss_mb = std::max(finished.peak_rss_mb, answer->at("peak_rss_mb").get<double>());
  } else {
    finished.result = outcome(Status::failed, exit_text(end));
  }
  std::error_code ignored;
  fs::remove(child.question, ignored);
  fs::remove(child.answer, ignored);
  return finished;
}

std::vector<FinishedJob> Supervisor::wait() {
  std::vector<const ChildProcess*> watched;
  for (const Child& child : children_) watched.push_back(child.process.get());
  wait_for_activity(watched);
  std::vector<FinishedJob> finished;
  std::vector<Child> still_running;
  for (Child& child : children_) {
    // Asked once: a child that ends a moment later is seen the next time.
    if (child.process->has_ended()) {
      finished.push_back(finish(child));
    } else {
      still_running.push_back(std::move(child));
    }
  }
  children_ = std::move(still_running);
  return finished;
}

}  // namespace gcslab
