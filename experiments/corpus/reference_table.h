#pragma once

// Figures of other programs on systems of the corpus, each table with its origin.
//
// They were not measured in the same run as ours, perhaps not on the same machine, and every report says so
// beside them. A file of kind `reference_table`:
//
//     kind: reference_table
//     name: ibex-2.9
//     title: ..    origin: ..    licence: ..    notes: ..
//     methods: {lp: "IBEX 2.9", no_lp: "IBEX 2.9 without LP"}     # what tables call each way it was run
//     rows:
//       - problem: kinematics/kin1       # of the corpus
//         called: Kin1                   # there; optional
//         runs: {lp: {status: complete, cpu_s: 0.077, boxes: 47, solutions: 16}}
//         note: ..
//
// Keys of a run: `status` in the words of base/outcome.h; `said`, what the program called it; times `cpu_s`
// and `wall_s` in seconds; counts `boxes`, `bisections`, `solutions` (certified), `undecided` (boxes),
// `lost_roots` (known roots in no box of its answer), and of constraint systems `classes`, `flat_classes` and
// `crossings`, `steps`.

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "base/outcome.h"

namespace gcslab {

/// One run of another program on a problem of the corpus.
struct ReferenceRun {
  std::string problem;  ///< name in the corpus
  std::string method;   ///< its label
  Status status = Status::failed;
  std::string reason;                          ///< the program's own word and the row's note; may be empty
  std::map<std::string, double> timings;       ///< seconds
  std::map<std::string, std::int64_t> counts;  ///< by the names of the task `solve`
};

struct ReferenceTable {
  std::string name;
  std::string title;
  std::string origin;
  std::string licence;
  std::string notes;
  std::vector<std::string> keys;     ///< of the methods, in the order of the file
  std::vector<std::string> methods;  ///< their labels
  std::vector<ReferenceRun> runs;
};

inline constexpr const char* kReferenceTableKind = "reference_table";

/// Throws InputError with file and line when the file is no such table.
ReferenceTable load_reference_table(const std::filesystem::path& path);

/// The table of that corpus name or path; "references/" may be left out. "ibex-2.9:lp" is the same with the
/// runs of one method alone. Throws InputError with the nearest name.
ReferenceTable find_reference_table(const std::string& name_or_path);

/// Loads the table and checks that the corpus has its problems. Throws InputError.
ReferenceTable check_reference_table(const std::filesystem::path& path);

}  // namespace gcslab
