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
};

/// "cpu model, compiler" of the first row that was run, for notes; empty when none was.
std::string machine_text(const RowTable& rows);

/// Who made the rows: the provenance of the first one that was run, or null.
Json first_provenance(const RowTable& rows);

}  // namespace gcslab
