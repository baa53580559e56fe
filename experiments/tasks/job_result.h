#pragma once

// What a task reports of one repetition, and the runner of a whole job.

#include <nlohmann/json.hpp>
#include <string>

#include "base/outcome.h"

namespace gcslab {

/// JSON that keeps the order in which keys were set.
using Json = nlohmann::ordered_json;

struct JobResult {
  Status status = Status::failed;
  std::string reason;  ///< empty when there is nothing to explain

  /// name -> integer, exact number (as text) or list of these: equal on every machine, compared exactly.
  Json values = Json::object();
  /// name -> seconds. Of a repetition: numbers; of a job: lists with one number a repetition. The runner
  /// measures the whole call as wall_s and cpu_s where the task does not measure its own (to leave out
  /// preparation, see Stopwatch).
  Json timings = Json::object();
  /// What figures draw; any JSON, null when there is nothing to draw.
  Json artifact = nullptr;
};

}  // namespace gcslab
