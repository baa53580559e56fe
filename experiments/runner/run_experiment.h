#pragma once

// Runs the jobs of an experiment that have no row yet.
//
// The promise: every job that was started and ended has a row, whatever came of it; rows are written whole,
// one by one, so that what is killed, at any moment and by any means, loses only the jobs that were running;
// the same command then goes on from there.

#include <cstddef>
#include <filesystem>
#include <iosfwd>
#include <map>

#include "base/outcome.h"
#include "experiments/runner/job_plan.h"

namespace gcslab {

struct ExperimentConfig;

struct RunOptions {
  std::filesystem::path runs = "build/runs";  ///< results go to runs/<experiment>
  std::size_t parallel = 1;                   ///< jobs at a time; more than one disturbs timings
  bool dry_run = false;                       ///< only show the plan
  bool fresh = false;                         ///< run every job, whether it has a row or not
  bool explain = false;                       ///< show why each job is cached, stale or fresh
  Shard shard;
};

struct RunSummary {
  std::map<Status, std::size_t> outcomes;  ///< of all jobs that have a row now
  std::size_t jobs = 0;                    ///< of the shard
  std::size_t run = 0;                     ///< in this run
  bool interrupted = false;
};

/// The folder of an experiment's results.
std::filesystem::path run_folder(const std::filesystem::path& runs, const ExperimentConfig& config);

/// Plan, explanations and summary go to `out`, progress to stderr. Throws InputError when the results cannot
/// be written or another run is going on in the folder. Only one thread of a process may run experiments.
RunSummary run_experiment(const ExperimentConfig& config, const RunOptions& options, std::ostream& out);

}  // namespace gcslab
