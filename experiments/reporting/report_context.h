#pragma once

// What tables and figures are made from.

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "experiments/reporting/row_table.h"
#include "experiments/tasks/task.h"

namespace gcslab {

using Point = std::array<double, 2>;
using Polyline = std::vector<Point>;

/// The true curve of a problem as polylines; empty when it has none that can be drawn.
using CurveSource = std::function<std::vector<Polyline>(const std::string& problem)>;

struct ReportContext {
  std::string experiment;
  std::string title;
  std::string source;
  int repetitions = 1;
  std::vector<std::string> baselines;  ///< labels of methods that promise nothing
  std::vector<ValueInfo> values;       ///< what the task's values mean
  RowTable rows;
  CurveSource curve;
};

/// "cpu model, compiler" of the first row that was run, for notes; empty when none was.
std::string machine_text(const RowTable& rows);

/// Who made the rows: the provenance of the first one that was run, or null.
Json first_provenance(const RowTable& rows);

}  // namespace gcslab
