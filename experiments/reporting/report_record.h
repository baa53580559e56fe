#pragma once

// What a report of one experiment says, kept as report.json beside its files, so that the index pages can be
// made again without the runs.

#include <filesystem>
#include <string>
#include <vector>

#include "experiments/tasks/job_result.h"

namespace gcslab {

struct ReportContext;

/// A table or figure of the report.
struct RecordedItem {
  bool is_figure = false;
  std::string file;  ///< without folder and extension
  std::string caption;
  std::vector<std::string> formats;  ///< extensions that were written
  std::vector<std::string> notes;    ///< of figures
  std::string html;                  ///< of tables
};

/// Jobs that ended otherwise than complete, grouped by outcome.
struct RecordedOutcome {
  std::string job;
  std::string outcome;
  std::string reason;
};

/// How the rows compare with the committed ones.
struct Verdict {
  enum class State { no_reference, equal, different };

  State state = State::no_reference;
  std::vector<std::string> lines;
};

struct ReportRecord {
  std::string experiment;
  std::string title;
  std::string source;
  std::size_t jobs = 0;
  std::vector<RecordedItem> items;
  std::vector<RecordedOutcome> outcomes;  ///< those that are not complete
  Json provenance = nullptr;              ///< of the first row that was run
  Verdict verdict;
};

/// The record of an experiment without items and verdict.
ReportRecord record_of(const ReportContext& context);

std::string to_text(const ReportRecord& record);
/// Throws InputError when the text is no record.
ReportRecord record_from_text(const std::string& text);

/// The records of all folders of `reports` that have one, in order of name. One that cannot be read is left
/// out and named in `unreadable`.
std::vector<ReportRecord> load_records(const std::filesystem::path& reports,
                                       std::vector<std::string>& unreadable);

/// "62 jobs: 60 complete, 2 n/a".
std::string count_text(const ReportRecord& record);

/// "machine: cpu", "program: commit, compiler, flags", ... as pairs of name and text.
std::vector<std::pair<std::string, std::string>> provenance_lines(const Json& provenance);

}  // namespace gcslab
