#pragma once

// The rows of an experiment on disk, and whether a row still answers its job.

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "experiments/runner/job_row.h"

namespace gcslab {

/// What is known of a job before a run.
struct JobState {
  enum class Kind {
    fresh,   ///< never asked
    stale,   ///< asked, but something changed since
    cached,  ///< its row stands
  };

  Kind kind = Kind::fresh;
  std::string reason;            ///< one line for a reader
  std::optional<Status> status;  ///< of the row that stands
};

std::string_view name_of(JobState::Kind kind);

/// Rows are found by the hash of their question. They are never removed: after a change is taken back, the
/// old rows stand again. Does not lock the folder (RunFolder does) and makes nothing until a row is saved.
class JobStore {
 public:
  explicit JobStore(const std::filesystem::path& run_folder) : jobs_(run_folder / "jobs") {}

  std::filesystem::path file_of(const std::string& job_id) const { return jobs_ / (job_id + ".json"); }

  /// The row of a job; none when it has none or the file is damaged (`damage`, if given, then says how).
  std::optional<JobRow> load(const std::string& job_id, std::string* damage = nullptr) const;

  /// Whether the row of the job can stand: its question is the same (that is what the hash says), it has as
  /// many repetitions, and its outcome does not hinge on limits that have changed.
  JobState state(const Job& job);

  /// Writes a row, in place of an older one. Throws InputError when it cannot; older rows stay as they were.
  void save(const JobRow& row);

 private:
  JobState state_without_row(const Job& job);
  const std::vector<JobRow>& rows_at(const std::string& place);

  std::filesystem::path jobs_;
  /// Rows without artifacts by the place in the experiment that they were made for; read when first needed.
  std::optional<std::map<std::string, std::vector<JobRow>>> by_place_;
};

}  // namespace gcslab
