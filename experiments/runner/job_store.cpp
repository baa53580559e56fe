#include "experiments/runner/job_store.h"

#include <algorithm>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/atomic_file.h"
#include "base/error.h"

namespace gcslab {
namespace {

namespace fs = std::filesystem;

/// As to_string(OptionValue) writes it.
std::string text_of(const Json& value) {
  if (value.is_string()) return value.get<std::string>();
  return value.is_number_float() ? fmt::format("{}", value.get<double>()) : value.dump();
}

std::string limits_text(const Limits& limits) {
  return fmt::format("wall {:g} s, CPU {:g} s, memory {:g} MB", limits.wall_s, limits.cpu_s,
                     limits.memory_mb);
}

bool ran_its_course(Status status) { return status == Status::complete || status == Status::partial; }

double most_of(const Json& timings, const char* name) {
  double most = 0;
  if (!timings.contains(name)) return most;
  for (const Json& seconds : timings.at(name)) {
    if (seconds.is_number()) most = std::max(most, seconds.get<double>());
  }
  return most;
}

/// Which of the limits of today the row would have exceeded; empty when none.
std::string exceeded_limit(const JobRow& row, const Limits& limits) {
  const double wall_s = most_of(row.result.timings, "wall_s");
  const double cpu_s = most_of(row.result.timings, "cpu_s");
  if (wall_s > limits.wall_s)
    return fmt::format("took {:.3g} s, the wall limit is now {:g} s", wall_s, limits.wall_s);
  if (cpu_s > limits.cpu_s)
    return fmt::format("took {:.3g} s CPU, the limit is now {:g} s", cpu_s, limits.cpu_s);
  if (row.peak_rss_mb > limits.memory_mb) {
    return fmt::format("took {:.3g} MB, the memory limit is now {:g} MB", row.peak_rss_mb, limits.memory_mb);
  }
  return "";
}

/// Why the row no longer stands; empty when it does.
std::string why_stale(const JobRow& row, const Job& job) {
  const Status status = row.result.status;
  if (ran_its_course(status) && row.repetitions < job.repetitions) {
    return fmt::format("has {} of {} repetitions", row.repetitions, job.repetitions);
  }
  const bool hit_limit = status == Status::budget_exhausted || status == Status::out_of_memory;
  if (hit_limit && row.limits != job.limits) {
    return fmt::format("ended {} under the limits {}; now they are {}", name_of(status),
                       limits_text(row.limits), limits_text(job.limits));
  }
  return ran_its_course(status) ? exceeded_limit(row, job.limits) : "";
}

std::string what_changed_in(const std::string& kind, const Json& before, const Json& now) {
  for (const auto& [name, value] : now.items()) {
    if (!before.contains(name)) return fmt::format("{} {} is new", kind, name);
    if (before.at(name) != value) {
      return fmt::format("{} {} was {}, is {}", kind, name, text_of(before.at(name)), text_of(value));
    }
  }
  return "";
}

/// Why an older row of the same place answers another question.
std::string what_changed(const JobRow& row, const JobRow& now) {
  if (row.problem_hash != now.problem_hash) return "problem " + now.problem + " has changed";
  if (row.method != now.method) return fmt::format("the method was {}, is {}", row.method, now.method);
  if (row.method_version != now.method_version) {
    return fmt::format("version of method {} was {}, is {}", now.method, row.method_version,
                       now.method_version);
  }
  const std::string options = what_changed_in("option", row.options, now.options);
  return options.empty() ? "the declared options or parameters have changed" : options;
}

/// The same text as Job::place().
std::string place_of(const JobRow& row) {
  std::string text = row.problem + ", " + row.label;
  for (const auto& [name, value] : row.parameters.items()) text += ", " + name + "=" + text_of(value);
  return text + ", seed=" + std::to_string(row.seed);
}

std::string made_text(const JobRow& row) {
  const Json& made = row.provenance;
  const auto field = [&](const char* name) {
    return made.contains(name) ? text_of(made.at(name)) : "unknown";
  };
  return fmt::format("{}, made {} by commit {}", name_of(row.result.status), field("started"),
                     field("commit").substr(0, 12));
}

}  // namespace

std::string_view name_of(JobState::Kind kind) {
  if (kind == JobState::Kind::fresh) return "fresh";
  return kind == JobState::Kind::stale ? "stale" : "cached";
}

std::optional<JobRow> JobStore::load(const std::string& job_id, std::string* damage) const {
  const fs::path file = file_of(job_id);
  std::error_code ignored;
  if (!fs::exists(file, ignored)) return std::nullopt;
  try {
    JobRow row = row_from_text(read_file(file));
    if (row.job == job_id) return row;
    throw InputError("is the row of job " + row.job);
  } catch (const InputError& error) {
    if (damage != nullptr) *damage = file.string() + " is damaged: " + error.what();
    return std::nullopt;
  }
}

JobState JobStore::state(const Job& job) {
  std::string damage;
  const auto row = load(job.id(), &damage);
  if (!damage.empty()) return {JobState::Kind::stale, damage, std::nullopt};
  if (!row) return state_without_row(job);
  const std::string stale = why_stale(*row, job);
  if (!stale.empty()) return {JobState::Kind::stale, stale, std::nullopt};
  return {JobState::Kind::cached, made_text(*row), row->result.status};
}

JobState JobStore::state_without_row(const Job& job) {
  const std::vector<JobRow>& rows = rows_at(job.place());
  if (rows.empty()) return {JobState::Kind::fresh, "never run", std::nullopt};
  return {JobState::Kind::stale, what_changed(rows.back(), make_row(job, {}, 0, nullptr)), std::nullopt};
}

const std::vector<JobRow>& JobStore::rows_at(const std::string& place) {
  if (!by_place_) {
    by_place_.emplace();
    std::error_code ignored;
    for (const fs::directory_entry& entry : fs::directory_iterator(jobs_, ignored)) {
      auto row = load(entry.path().stem().string());
      if (!row) continue;
      row->result.artifact = nullptr;
      (*by_place_)[place_of(*row)].push_back(std::move(*row));
    }
    const auto started = [](const JobRow& row) { return row.provenance.value("started", std::string()); };
    for (auto& [ignored_place, rows] : *by_place_) std::ranges::sort(rows, {}, started);
  }
  return (*by_place_)[place];
}

void JobStore::save(const JobRow& row) {
  make_folder(jobs_);
  write_file_atomically(file_of(row.job), to_text(row));
}

}  // namespace gcslab
