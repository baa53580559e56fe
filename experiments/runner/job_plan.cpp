#include "experiments/runner/job_plan.h"

#include <charconv>
#include <map>

#include "base/error.h"
#include "experiments/runner/experiment_config.h"

namespace gcslab {
namespace {

using Texts = std::map<std::string, std::string>;

/// Every combination of values, the last axis varying fastest.
std::vector<Options> parameter_combinations(const ExperimentConfig& config) {
  std::vector<Texts> combinations = {{}};
  for (const ParameterAxis& axis : config.parameters) {
    std::vector<Texts> longer;
    for (const Texts& combination : combinations) {
      for (const std::string& value : axis.values) {
        longer.push_back(combination);
        longer.back()[axis.name] = value;
      }
    }
    combinations = std::move(longer);
  }
  std::vector<Options> result;
  result.reserve(combinations.size());
  for (const Texts& texts : combinations)
    result.emplace_back(config.declared_parameters, texts, "task " + config.task);
  return result;
}

Job make_job(const ExperimentConfig& config, const ProblemChoice& problem, const MethodChoice& method) {
  Job job;
  job.experiment = config.experiment;
  job.task = config.task;
  job.problem = problem.name;
  job.problem_hash = problem.content_hash;
  job.method = method.name;
  job.label = method.label;
  job.method_version = method.version;
  job.options = method.options;
  job.repetitions = config.repetitions;
  job.limits = config.limits;
  return job;
}

void refuse_equal_jobs(const std::vector<Job>& jobs, const ExperimentConfig& config) {
  std::map<std::string, const Job*> known;
  for (const Job& job : jobs) {
    const auto [earlier, is_new] = known.emplace(job.id(), &job);
    if (is_new) continue;
    throw InputError({config.file.string(), 0}, "problems '" + earlier->second->problem + "' and '" +
                                                    job.problem + "' have the same content; leave one out");
  }
}

template <class Number>
bool read_number(const char*& begin, const char* end, Number& number) {
  const auto [stop, error] = std::from_chars(begin, end, number);
  begin = stop;
  return error == std::errc{};
}

}  // namespace

std::vector<Job> plan_jobs(const ExperimentConfig& config) {
  const std::vector<Options> combinations = parameter_combinations(config);
  std::vector<Job> jobs;
  for (const ProblemChoice& problem : config.problems) {
    for (const MethodChoice& method : config.methods) {
      Job job = make_job(config, problem, method);
      for (const Options& parameters : combinations) {
        job.parameters = parameters;
        for (const std::uint64_t seed : config.seeds) {
          job.seed = seed;
          jobs.push_back(job);
        }
      }
    }
  }
  refuse_equal_jobs(jobs, config);
  return jobs;
}

Shard Shard::parse(const std::string& text) {
  Shard shard;
  const char* begin = text.data();
  const char* const end = begin + text.size();
  const bool read = read_number(begin, end, shard.index) && begin != end && *begin++ == '/' &&
                    read_number(begin, end, shard.count) && begin == end;
  if (!read || shard.index < 1 || shard.index > shard.count) {
    throw InputError("--shard is '" + text + "'; expected k/n with 1 <= k <= n, for example 2/5");
  }
  return shard;
}

std::vector<Job> jobs_of_shard(const std::vector<Job>& jobs, const Shard& shard) {
  std::vector<Job> part;
  for (std::size_t i = shard.index - 1; i < jobs.size(); i += shard.count) part.push_back(jobs[i]);
  return part;
}

}  // namespace gcslab
