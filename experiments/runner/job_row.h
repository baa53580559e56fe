#pragma once

// The row of a job: what was asked, what came of it, by which program and where. One JSON file.

#include <cstdint>
#include <string>

#include "experiments/tasks/catalogue.h"
#include "experiments/tasks/job_result.h"

namespace gcslab {

struct JobRow {
  std::string job;  ///< Job::id()
  std::string experiment;
  std::string task;
  std::string problem;
  std::string problem_hash;
  std::string method;
  std::string label;
  Json options;  ///< name -> flag, number or word; defaults filled in
  int method_version = 1;
  Json parameters;
  std::uint64_t seed = 1;
  int repetitions = 1;  ///< as asked for; fewer were made when one did not run its course
  Limits limits;
  JobResult result;
  double peak_rss_mb = 0;
  Json provenance;
};

/// The question alone, as the first keys of a row.
Json question_json(const Job& job);

/// The question that a row file (or a file of question_json) holds. Throws InputError when it is not one, or
/// when this program would ask it under another name because a method has changed.
Job job_from_text(const std::string& text, const TaskRegistry& tasks);

JobRow make_row(const Job& job, JobResult result, double peak_rss_mb, Json provenance);

/// The text of a row file: one key a line.
std::string to_text(const JobRow& row);
/// Throws InputError when the text is no row.
JobRow row_from_text(const std::string& text);

/// {"status", "reason", "values", "timings", "artifact"}; numbers that are not finite become texts.
Json result_json(const JobResult& result);
JobResult result_from_json(const Json& json);

/// The text of a JSON map: the outermost keys a line each, all else compact.
std::string map_text(const Json& map);

}  // namespace gcslab
