#include "experiments/reporting/table_kind.h"

#include <map>

#include "base/error.h"
#include "experiments/reporting/measure.h"
#include "experiments/runner/report_item.h"

namespace gcslab {
namespace {

const TableKind& kind_of(const ReportItem& item) {
  if (item.kind.empty()) return table_kinds().at("cells");
  try {
    return table_kinds().at(item.kind);
  } catch (const InputError& error) {
    throw InputError(item.where, error.what());
  }
}

void check_axes(const ReportItem& item, const TableKind& kind) {
  if (kind.has_axes) {
    if (item.rows.empty() || item.values.empty())
      throw InputError(item.where, "a table of kind " + kind.name + " needs rows and values");
  } else if (!item.rows.empty() || !item.columns.empty() || !item.best.empty()) {
    throw InputError(item.where, "a table of kind " + kind.name + " takes no rows, columns and best");
  }
}

void check_values(const ReportItem& item, const TableKind& kind) {
  for (const std::string& name : item.values) {
    try {
      static_cast<void>(ValueName(name));
    } catch (const InputError& error) {
      throw InputError(item.where, error.what());
    }
  }
  if (!kind.has_axes && item.values.size() > 1)
    throw InputError(item.where, "a table of kind " + kind.name + " compares one value");
}

}  // namespace

const Registry<TableKind>& table_kinds() {
  static const Registry<TableKind> kinds(
      "kind of table", {cells_table_kind(), summary_table_kind(), against_table_kind(), counts_table_kind(),
                        deviations_table_kind(), basins_table_kind()});
  return kinds;
}

Options options_of(const ReportItem& item, const TableKind& kind) {
  std::map<std::string, std::string> given;
  for (const auto& [name, value] : item.options) {
    given[name] = value.text;
    try {
      static_cast<void>(Options(kind.options, {{name, value.text}}, "a table"));
    } catch (const InputError& error) {
      throw InputError(value.where, error.what());
    }
  }
  return {kind.options, given, "a table"};
}

Table build_table(const ReportItem& item, const ReportContext& context) {
  return kind_of(item).build(item, context);
}

void check_table(const ReportItem& item) {
  const TableKind& kind = kind_of(item);
  static_cast<void>(options_of(item, kind));
  check_axes(item, kind);
  check_values(item, kind);
}

}  // namespace gcslab
