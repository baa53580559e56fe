#include "experiments/runner/run_experiment.h"

#include <deque>
#include <fmt/format.h>
#include <iostream>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "base/atomic_file.h"
#include "base/check.h"
#include "experiments/provenance.h"
#include "experiments/runner/experiment_config.h"
#include "experiments/runner/interrupt.h"
#include "experiments/runner/job_store.h"
#include "experiments/runner/progress.h"
#include "experiments/runner/run_folder.h"
#include "experiments/runner/supervisor.h"

namespace gcslab {
namespace {

namespace fs = std::filesystem;

struct PlannedJob {
  Job job;
  JobState state;
};

using Plan = std::vector<PlannedJob>;

Plan make_plan(const ExperimentConfig& config, const RunOptions& options) {
  JobStore store(run_folder(options.runs, config));
  Plan plan;
  for (Job& job : jobs_of_shard(plan_jobs(config), options.shard)) {
    JobState state = store.state(job);
    if (options.fresh && state.kind == JobState::Kind::cached) {
      state = {JobState::Kind::stale, "--fresh asks for it again", std::nullopt};
    }
    plan.push_back({std::move(job), std::move(state)});
  }
  return plan;
}

// ---- what is shown
// ---------------------------------------------------------------------------------------------------

void show_plan(const Plan& plan, const RunOptions& options, std::ostream& out) {
  for (const PlannedJob& planned : plan) {
    out << fmt::format("{:6} {}", name_of(planned.state.kind), planned.job.place());
    if (options.explain) out << ": " << planned.state.reason;
    out << '\n';
  }
}

void show_states(const ExperimentConfig& config, const Plan& plan, const RunOptions& options,
                 std::ostream& out) {
  std::map<JobState::Kind, std::size_t> count;
  for (const PlannedJob& planned : plan) ++count[planned.state.kind];
  const Shard& shard = options.shard;
  out << fmt::format("{}: {} {}{}: {} cached, {} stale, {} fresh\n", config.experiment, plan.size(),
                     plan.size() == 1 ? "job" : "jobs",
                     shard.count > 1 ? fmt::format(" in shard {}/{}", shard.index, shard.count) : "",
                     count[JobState::Kind::cached], count[JobState::Kind::stale],
                     count[JobState::Kind::fresh])
      << std::flush;
}

void show_summary(const ExperimentConfig& config, const RunOptions& options, const RunSummary& summary,
                  std::ostream& out) {
  std::string outcomes;
  for (const auto& [status, count] : summary.outcomes)
    outcomes += fmt::format(", {} {}", count, name_of(status));
  out << fmt::format("{}: {} run now{}; rows in {}\n", config.experiment, summary.run, outcomes,
                     (run_folder(options.runs, config) / "jobs").string())
      << std::flush;
}

// ---- the run
// ---------------------------------------------------------------------------------------------------------

/// One run: starts jobs, files their rows, stops when it is interrupted.
class Run {
 public:
  Run(const ExperimentConfig& config, const RunOptions& options, const fs::path& folder,
      const fs::path& exchange)
      : options_(options), store_(folder), supervisor_(exchange), experiment_(config.experiment) {}

  RunSummary go(const Plan& plan) {
    summary_.jobs = plan.size();
    for (const PlannedJob& planned : plan) take_in(planned);
    Progress progress(std::cerr, isatty(STDERR_FILENO) == 1, experiment_, waiting_.size());
    while (!InterruptGuard::interrupted() && (!waiting_.empty() || supervisor_.running() > 0)) {
      start_jobs();
      progress.tick(supervisor_.running());
      for (FinishedJob& job : supervisor_.wait()) {
        progress.finished(job);
        file(std::move(job));
      }
    }
    summary_.interrupted = !waiting_.empty() || supervisor_.running() > 0;
    return summary_;
  }

 private:
  void take_in(const PlannedJob& planned) {
    if (planned.state.status) {
      ++summary_.outcomes[*planned.state.status];
    } else {
      waiting_.push_back(&planned.job);
    }
  }

  void start_jobs() {
    while (!waiting_.empty() && supervisor_.running() < options_.parallel) {
      supervisor_.start(*waiting_.front());
      waiting_.pop_front();
    }
  }

  void file(FinishedJob finished) {
    ++summary_.run;
    ++summary_.outcomes[finished.result.status];
    store_.save(make_row(finished.job, std::move(finished.result), finished.peak_rss_mb,
                         provenance(finished.job.seed, finished.started)));
  }

  const RunOptions& options_;
  JobStore store_;
  Supervisor supervisor_;
  std::string experiment_;
  std::deque<const Job*> waiting_;
  RunSummary summary_;
};

std::size_t rows_of(const RunSummary& summary) {
  std::size_t rows = 0;
  for (const auto& [status, count] : summary.outcomes) rows += count;
  return rows;
}

void say_interrupted(const RunSummary& summary) {
  std::cerr << fmt::format("interrupted: {} of {} jobs have a row; the same command goes on from there\n",
                           rows_of(summary), summary.jobs);
}

}  // namespace

fs::path run_folder(const fs::path& runs, const ExperimentConfig& config) { return runs / config.experiment; }

RunSummary run_experiment(const ExperimentConfig& config, const RunOptions& options, std::ostream& out) {
  if (options.dry_run) {
    const Plan plan = make_plan(config, options);
    show_states(config, plan, options, out);
    show_plan(plan, options, out);
    return {{}, plan.size(), 0, false};
  }
  const InterruptGuard guard;
  const RunFolder folder(run_folder(options.runs, config));
  const Plan plan = make_plan(config, options);
  show_states(config, plan, options, out);
  if (options.explain) show_plan(plan, options, out);
  RunSummary summary = Run(config, options, folder.folder(), folder.exchange()).go(plan);
  if (summary.interrupted) {
    say_interrupted(summary);
    return summary;
  }
  GCSLAB_CHECK(rows_of(summary) == summary.jobs);  // no outcome loses its row
  write_file_atomically(folder.folder() / "experiment.yaml", read_file(config.file));
  show_summary(config, options, summary, out);
  return summary;
}

}  // namespace gcslab
