#pragma once

// Rows of today against the committed ones: counts and outcomes exactly, timings as ratios.
//
// A difference in a value or outcome, or a row that is gone, is a failed check. A slower machine is not: the
// values of a row that ran out of time are not compared.

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "experiments/reporting/report_record.h"

namespace gcslab {

struct ReportContext;

/// All rows without artifacts, as the text of rows.json: {"experiment", "provenance", "rows": [{"job",
/// "axes", "status", "reason", "values", "timings": medians, "peak_rss_mb"}, ..]}, one row a line.
std::string rows_text(const ReportContext& context);

/// How the times of today compare with those of the reference, over all rows that have both.
struct TimingRatio {
  std::string timing;
  double geometric_mean = 1;
  double least = 1, greatest = 1;
  std::string least_place, greatest_place;
  std::size_t rows = 0;
};

struct Comparison {
  std::vector<std::string>
      differences;  ///< "cassini-2-2, natural, depth 8, seed 1: kept_cells was 2180, is 2181"
  std::vector<std::string> missing;  ///< rows of the reference that are gone
  std::vector<std::string> added;    ///< rows that the reference does not have
  std::vector<TimingRatio> timings;
  std::size_t equal_rows = 0;
  std::size_t reference_rows = 0;

  bool agrees() const { return differences.empty() && missing.empty(); }
};

/// Compares two texts of rows.json. Throws InputError when the reference cannot be read.
Comparison compare_rows(const std::string& now, const std::string& reference);

/// The comparison in sentences, differences first.
Verdict verdict_of(const Comparison& comparison);

}  // namespace gcslab
