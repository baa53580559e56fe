#pragma once

// A job of an experiment as reports see it: its place on every axis, and what became of it.

#include <map>
#include <string>
#include <vector>

#include "experiments/tasks/job_result.h"

namespace gcslab {

/// Status words of a row beyond those of base/outcome.h: the job has no row file, or one that cannot be read.
inline constexpr const char* kNotRun = "not_run";
inline constexpr const char* kDamaged = "damaged";

struct Row {
  std::string job;  ///< its id
  /// "problem", "method" (the label), "seed" and the parameters that the config names.
  std::map<std::string, std::string> axes;
  std::map<std::string, std::string> constants;  ///< parameters that it does not name
  std::string status = kNotRun;                  ///< a word of base/outcome.h, kNotRun or kDamaged
  std::string reason;
  Json values = Json::object();
  Json timings = Json::object();
  double peak_rss_mb = 0;
  Json artifact = nullptr;
  Json provenance = nullptr;
  bool is_reference = false;  ///< a figure of another program: not measured in this run

  /// The row's text on an axis or for a constant; empty when it has neither.
  std::string at(const std::string& axis) const;
  /// The method ran its course, so that its values may be compared: complete or partial.
  bool has_result() const { return status == "complete" || status == "partial"; }
  bool was_run() const { return status != kNotRun && status != kDamaged; }
};

/// "cassini-2-2, bernstein, depth 8, seed 1".
std::string place_text(const Row& row);

/// The outcome in the one or two words that fit a table's cell: "n/a", "timeout", "out of memory", "not run".
std::string outcome_word(const Row& row);

}  // namespace gcslab
