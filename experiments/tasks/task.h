#pragma once

// A task is a question that an experiment asks of every problem by every method: "cover the curve".
//
// The promise: the result of a job follows from the job alone (problem content, method, options, method
// version, parameters, seed), so that a job is known again by a hash of these. Wall time, threads and the
// machine show in the timings only. A new task is one source file here and one line in registry.cpp.

#include <cstdint>
#include <functional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "base/option.h"
#include "base/outcome.h"
#include "experiments/process/limits.h"

namespace gcslab {

struct JobResult;  // tasks/job_result.h

/// One question: a problem, a method and all settings. Every declared option and parameter has a value.
struct Job {
  std::string experiment;
  std::string task;
  std::string problem;       ///< name in the corpus, or path
  std::string problem_hash;  ///< of the problem's content
  std::string method;
  std::string label;  ///< what tables call the method with these options
  int method_version = 1;
  Options options;     ///< of the method
  Options parameters;  ///< of the task
  std::uint64_t seed = 1;
  int repetitions = 1;
  Limits limits;

  /// The name of the question: a hash of everything that its answer may depend on, and of nothing else (so
  /// not of label, repetitions and limits).
  std::string id() const;
  /// The place of the job in its experiment, "problem, method label, parameters, seed": a job whose problem,
  /// options or method version changed takes the place of an older one.
  std::string place() const;
};

/// One method of a task.
struct MethodInfo {
  std::string name;
  std::string summary;  ///< one line
  Promise promise = Promise::rigorous;
  int version = 1;  ///< raised when the answers (values, counts) of the method change
  std::vector<OptionSpec> options{};
  /// Where some options are baselines: the promise of the method with these. Empty: `promise`, whatever they
  /// are.
  std::function<Promise(const Options&)> promise_with{};
};

/// One number that the results of a task hold, for tables and `gcslab describe`.
struct ValueInfo {
  std::string name;
  std::string meaning;
  std::string unit{};
};

class Task {
 public:
  virtual ~Task() = default;

  virtual std::string name() const = 0;
  virtual std::string summary() const = 0;
  virtual std::vector<MethodInfo> methods() const = 0;
  /// Settings of the question itself, such as the depth of a cover.
  virtual std::vector<OptionSpec> parameters() const { return {}; }
  /// The values that results hold; no result holds another. Timings are not listed.
  virtual std::vector<ValueInfo> values() const = 0;
  /// The kinds of problem files that it takes.
  virtual std::vector<std::string> problem_kinds() const = 0;

  /// Throws InputError when the job is no question at all (wrong kind of problem, file that does not load).
  /// Called for every job before the first one starts. A method that does not apply is no fault: it is an
  /// outcome of run().
  virtual void check(const Job& job) const = 0;

  /// Answers once, and gives up with budget_exhausted soon after `stop` is requested. Called once a
  /// repetition, in a process of its own. Exceptions become outcomes: NotApplicable, std::bad_alloc (out of
  /// memory), all others (failed).
  virtual JobResult run(const Job& job, const std::stop_token& stop) const = 0;

  /// The method of that name. Throws InputError with the nearest name.
  MethodInfo method(std::string_view method_name) const;
};

}  // namespace gcslab
