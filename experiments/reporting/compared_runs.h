#pragma once

// What tables that compare methods by one cost start from.

#include "experiments/reporting/report_context.h"
#include "experiments/reporting/solver_comparison.h"
#include "experiments/reporting/table_kind.h"
#include "experiments/runner/report_item.h"

namespace gcslab {

struct ComparedRuns {
  /// The item and the context must outlive it.
  ComparedRuns(const ReportItem& table, const ReportContext& all, const TableKind& kind)
      : item(table),
        context(all),
        options(options_of(table, kind)),
        rows(all, table),
        comparison(rows.all()),
        value(table.values.empty() ? "cpu_s" : table.values.front()),
        solved(solved_from(options)) {}

  /// Of a method on a problem, where it solves it.
  std::optional<double> cost(std::size_t problem, std::size_t method) const {
    return comparison.cost(problem, method, value, solved);
  }

  const ReportItem& item;
  const ReportContext& context;
  Options options;
  SelectedRows rows;
  SolverComparison comparison;
  ValueName value;  ///< the cost
  Solved solved;
};

}  // namespace gcslab
