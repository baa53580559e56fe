#pragma once

// What tables and figures are made from.

#include <array>
#include <deque>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "experiments/corpus/reference_table.h"
#include "experiments/reporting/row_table.h"
#include "experiments/tasks/task.h"

namespace gcslab {

struct ReportItem;

using Point = std::array<double, 2>;
using Polyline = std::vector<Point>;

/// The zero sets of a problem's functions as polylines, one list a function; none where the problem has not
/// two variables or no bounded box.
struct ProblemCurves {
  std::vector<std::vector<Polyline>> equations;
  std::vector<std::vector<Polyline>> inequalities;  ///< where they hold with equality
};
/// The curve of a problem with one equation.
std::vector<Polyline> first_curve(const ProblemCurves& curves);

using CurveSource = std::function<ProblemCurves(const std::string& problem)>;

struct ReportContext {
  std::string experiment;
  std::string title;
  std::string source;
  int repetitions = 1;
  std::vector<std::string> baselines;  ///< labels of methods that promise nothing
  std::vector<ValueInfo> values;       ///< what the task's values mean
  RowTable rows;
  CurveSource curve;
  /// What the items of the report refer to, by the name they use.
  std::map<std::string, ReferenceTable> references{};
  Limits limits{};  ///< of each job
};

/// The rows that an item speaks of: those that pass its filter, and after them, as further methods, the
/// figures of other programs on the same problems. The label of such a method ends in "(not the same run)".
/// The rows live as long as the answer.
class SelectedRows {
 public:
  /// Throws InputError when no row passes, or when reference figures would stand beside several values of an
  /// axis that they do not have.
  SelectedRows(const ReportContext& context, const ReportItem& item);

  SelectedRows(const SelectedRows&) = delete;
  SelectedRows& operator=(const SelectedRows&) = delete;

  const RowPointers& all() const { return rows_; }

 private:
  void add(const ReferenceTable& table);

  std::deque<Row> references_;
  RowPointers rows_;
};

/// A sentence for each table of references that an item shows: "Not the same run: ...".
std::vector<std::string> notes_on_references(const ReportContext& context, const ReportItem& item);

/// "cpu model, compiler" of the first row that was run, for notes; empty when none was.
std::string machine_text(const RowTable& rows);

/// Who made the rows: the provenance of the first one that was run, or null.
Json first_provenance(const RowTable& rows);

}  // namespace gcslab
