#pragma once

// All jobs of an experiment, in one order that depends on the config alone, so that `--shard k/n` splits it
// the same way on every machine.

#include <cstddef>
#include <string>
#include <vector>

#include "experiments/tasks/task.h"

namespace gcslab {

struct ExperimentConfig;

/// Problems x methods x parameter combinations x seeds, the last varying fastest. Throws InputError when two
/// of them are the same question (problems of equal content).
std::vector<Job> plan_jobs(const ExperimentConfig& config);

/// Part `index` (from 1) of `count`: every count-th job. The parts are disjoint and make up the plan.
struct Shard {
  std::size_t index = 1;
  std::size_t count = 1;

  /// Reads "2/5". Throws InputError.
  static Shard parse(const std::string& text);
};

std::vector<Job> jobs_of_shard(const std::vector<Job>& jobs, const Shard& shard);

}  // namespace gcslab
