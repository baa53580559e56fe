#pragma once

// The rows of one experiment in the order of its plan, and how they fall into groups.
//
// No job is ever left out: one without a row file, or with one that cannot be read, is a row that says so.

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "experiments/reporting/row.h"

namespace gcslab {

struct Job;
struct ReportItem;

/// Texts on some axes, in the order of these axes.
using AxisKey = std::vector<std::string>;
using RowPointers = std::vector<const Row*>;

class RowTable {
 public:
  /// `axes` in the order in which texts name them: problem, method, parameters, seed. Every row has all of
  /// them.
  RowTable(std::vector<std::string> axes, std::vector<Row> rows);

  const std::vector<std::string>& axes() const { return axes_; }
  const std::vector<Row>& rows() const { return rows_; }
  /// The texts that occur on an axis, in the order of the plan.
  std::vector<std::string> values_of(const std::string& axis) const;

 private:
  std::vector<std::string> axes_;
  std::vector<Row> rows_;
};

/// Reads `<jobs folder>/<job id>.json` for every job of the plan. `parameters` become axes; others of the
/// task, which have one value throughout, do not.
RowTable load_rows(const std::vector<Job>& plan, const std::vector<std::string>& parameters,
                   const std::filesystem::path& jobs_folder);

/// The rows that an item of the report speaks of: those on the filter's values.
RowPointers select_rows(const RowTable& table, const ReportItem& item);

/// The keys of the rows on the given axes, sorted axis by axis into the order of the plan.
std::vector<AxisKey> keys_on(const RowPointers& rows, const std::vector<std::string>& axes);
AxisKey key_of(const Row& row, const std::vector<std::string>& axes);
RowPointers rows_at(const RowPointers& rows, const std::vector<std::string>& axes, const AxisKey& key);

/// Refuses rows that differ, within one group of `axes`, in anything but the seed: a median over several
/// depths would mean nothing. Throws InputError that names the axis and what to do.
void check_groups(const RowPointers& rows, const std::vector<std::string>& axes, const ReportItem& item);

/// Axes other than the seed on which all these rows agree, as "folium, depth 8"; those in `shown` are left
/// out.
std::string common_axes_text(const RowPointers& rows, const std::vector<std::string>& shown);

/// How a text on an axis reads in a heading: a problem without its folder, "depth 8", "seed 1".
std::string heading_of(const std::string& axis, const std::string& text);

}  // namespace gcslab
