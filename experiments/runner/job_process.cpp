#include "experiments/runner/job_process.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <fmt/format.h>
#include <fstream>
#include <limits>
#include <mutex>
#include <new>
#include <nlohmann/json.hpp>
#include <thread>

#include "base/atomic_file.h"
#include "base/check.h"
#include "experiments/runner/job_row.h"
#include "experiments/tasks/job_result.h"
#include "experiments/tasks/memory_use.h"
#include "experiments/tasks/stopwatch.h"

namespace gcslab {
namespace {

// ---- the limits of one repetition
// ------------------------------------------------------------------------------------

/// Requests a stop when one repetition has used up its wall or CPU time.
class Deadline {
 public:
  explicit Deadline(const Limits& limits)
      : limits_(limits), watcher_([this](const std::stop_token& done) { watch(done); }) {}

  std::stop_token token() const { return stop_.get_token(); }

  /// Which limit is exceeded by now; empty when none is.
  std::string exceeded() const {
    if (stopwatch_.wall_s() > limits_.wall_s) return wall_limit_text(limits_);
    if (stopwatch_.cpu_s() > limits_.cpu_s) return cpu_limit_text(limits_);
    return "";
  }

 private:
  /// Until the next look. CPU time has to be looked at; wall time comes at a known moment.
  std::chrono::duration<double> pause() const {
    constexpr double kLook_s = 0.02;
    constexpr double kLongest_s = 1e6;
    const double left = std::clamp(limits_.wall_s - stopwatch_.wall_s(), 1e-4, kLongest_s);
    return std::chrono::duration<double>(limits_.cpu_s < kLongest_s ? std::min(left, kLook_s) : left);
  }

  void watch(const std::stop_token& done) {
    std::unique_lock lock(mutex_);
    while (!done.stop_requested() && exceeded().empty()) {
      wake_.wait_for(lock, done, pause(), [] { return false; });
    }
    if (!done.stop_requested()) stop_.request_stop();
  }

  Limits limits_;
  Stopwatch stopwatch_;
  std::stop_source stop_;
  std::mutex mutex_;
  std::condition_variable_any wake_;
  std::jthread watcher_;
};

// ---- one repetition
// --------------------------------------------------------------------------------------------------

JobResult outcome(Status status, std::string reason) {
  JobResult result;
  result.status = status;
  result.reason = std::move(reason);
  return result;
}

void check_names(const JobResult& result, const Task& task) {
  const std::vector<ValueInfo> declared = task.values();
  for (const auto& [name, value] : result.values.items()) {
    if (std::ranges::find(declared, name, &ValueInfo::name) == declared.end()) {
      throw InvariantError("task " + task.name() + " reports the value '" + name +
                           "', which it does not declare");
    }
  }
  for (const auto& [name, seconds] : result.timings.items()) {
    if (!seconds.is_number())
      throw InvariantError("timing '" + name + "' of task " + task.name() + " is no number");
  }
}

/// One call of the task, with its time measured and its limits applied.
JobResult answer_once(const Task& task, const Job& job) {
  const Deadline deadline(job.limits);
  const Stopwatch stopwatch;
  JobResult result = task.run(job, deadline.token());
  const double wall_s = stopwatch.wall_s();
  const double cpu_s = stopwatch.cpu_s();
  const std::string exceeded = deadline.exceeded();
  check_names(result, task);
  if (!result.timings.contains("wall_s")) result.timings["wall_s"] = wall_s;
  if (!result.timings.contains("cpu_s")) result.timings["cpu_s"] = cpu_s;
  if (exceeded.empty()) return result;
  result.status = Status::budget_exhausted;
  result.reason = result.reason.empty() ? exceeded : exceeded + ": " + result.reason;
  return result;
}

JobResult answer_or_outcome(const Task& task, const Job& job) {
  try {
    return answer_once(task, job);
  } catch (const NotApplicable& reason) {
    return outcome(Status::not_applicable, reason.what());
  } catch (const std::bad_alloc&) {
    return outcome(Status::out_of_memory, memory_limit_text(job.limits));
  } catch (const InvariantError& error) {
    return outcome(Status::failed, std::string("fault of the program: ") + error.what());
  } catch (const std::exception& error) {
    return outcome(Status::failed, error.what());
  } catch (...) {
    return outcome(Status::failed, "fault of the program: an exception of unknown type");
  }
}

// ---- all repetitions
// -------------------------------------------------------------------------------------------------

bool ran_its_course(const JobResult& result) {
  return result.status == Status::complete || result.status == Status::partial;
}

/// The first difference between two repetitions, or "".
std::string difference(const JobResult& first, const JobResult& later) {
  if (first.status != later.status) {
    return fmt::format("status {}, then {}", name_of(first.status), name_of(later.status));
  }
  for (const auto& [name, value] : first.values.items()) {
    if (!later.values.contains(name)) return fmt::format("'{}' {}, then missing", name, value.dump());
    if (later.values.at(name) != value) {
      return fmt::format("'{}' {}, then {}", name, value.dump(), later.values.at(name).dump());
    }
  }
  return first.values.size() == later.values.size() ? "" : "more values later";
}

void append_timings(Json& lists, const Json& timings) {
  for (const auto& [name, seconds] : timings.items()) lists[name].push_back(seconds);
}

void check_problem(const Job& job, const Catalogue& catalogue) {
  if (catalogue.problems.content_hash(job.problem) == job.problem_hash) return;
  throw InputError("problem " + job.problem + " has changed while the experiment runs; run it again");
}

}  // namespace

JobResult run_repetitions(const Task& task, const Job& job) {
  JobResult total;
  Json timings = Json::object();
  for (int repetition = 0; repetition < job.repetitions; ++repetition) {
    JobResult next = answer_or_outcome(task, job);
    append_timings(timings, next.timings);
    if (repetition > 0 && ran_its_course(next)) {
      const std::string differs = difference(total, next);
      if (!differs.empty()) next = outcome(Status::failed, "repetitions differ: " + differs);
    }
    total = std::move(next);
    if (!ran_its_course(total)) break;
  }
  total.timings = std::move(timings);
  return total;
}

void run_job_file(const std::filesystem::path& question, const std::filesystem::path& answer,
                  const Catalogue& catalogue) {
  const Job job = job_from_text(read_file(question), catalogue.tasks);
  check_problem(job, catalogue);
  JobResult result = run_repetitions(*catalogue.tasks.at(job.task).task, job);
  const double peak = peak_rss_mb();
  if (peak > job.limits.memory_mb) result = outcome(Status::out_of_memory, memory_limit_text(job.limits));
  Json json = result_json(result);
  json["peak_rss_mb"] = peak;
  write_file_atomically(answer, map_text(json));
}

std::string wall_limit_text(const Limits& limits) {
  return fmt::format("wall limit of {:g} s", limits.wall_s);
}
std::string cpu_limit_text(const Limits& limits) { return fmt::format("CPU limit of {:g} s", limits.cpu_s); }
std::string memory_limit_text(const Limits& limits) {
  return fmt::format("memory limit of {:g} MB", limits.memory_mb);
}

}  // namespace gcslab
