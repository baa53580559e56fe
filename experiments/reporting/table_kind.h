#pragma once

// The kinds of tables, as figure.h has the kinds of figures. A new kind is one source file and one line in
// table_kind.cpp.

#include <functional>
#include <string>
#include <vector>

#include "base/option.h"
#include "base/registry.h"
#include "experiments/reporting/table.h"

namespace gcslab {

struct TableKind {
  std::string name;
  std::string summary;
  std::vector<OptionSpec> options;
  std::function<Table(const ReportItem&, const ReportContext&)> build;
  /// Whether it takes `rows`, `columns` and `best`. One that does not has methods or problems as lines.
  bool has_axes = false;
};

const Registry<TableKind>& table_kinds();

/// The options of an item of that kind, with defaults. Throws InputError with the place in the config.
Options options_of(const ReportItem& item, const TableKind& kind);

TableKind cells_table_kind();
TableKind summary_table_kind();
TableKind against_table_kind();
TableKind counts_table_kind();
TableKind deviations_table_kind();
TableKind basins_table_kind();

}  // namespace gcslab
