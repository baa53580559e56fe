#pragma once

// The inside of a job's process: asks the question once a repetition and writes the answer.

#include <filesystem>
#include <string>

#include "experiments/tasks/catalogue.h"

namespace gcslab {

/// The exit code by which a job's process says that no job can go on; the last line of stderr says why.
constexpr int kCannotGoOn = 74;

/// Reads the job in `question` (a row file will do), runs it and writes its result to `answer`, by atomic
/// rename. Every outcome of the task is a result. Throws InputError when a file cannot be read or written.
void run_job_file(const std::filesystem::path& question, const std::filesystem::path& answer,
                  const Catalogue& catalogue);

/// All repetitions of the job, in this process. Stops after the first that does not run its course. Values
/// that differ between repetitions are a failure: they are to follow from the job alone.
JobResult run_repetitions(const Task& task, const Job& job);

// "wall limit of 60 s": the reasons of outcomes.
std::string wall_limit_text(const Limits& limits);
std::string cpu_limit_text(const Limits& limits);
std::string memory_limit_text(const Limits& limits);

}  // namespace gcslab
