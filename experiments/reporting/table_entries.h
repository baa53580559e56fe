#pragma once

// The numbers of a table before they are laid out: what stands at each place, and which of the methods is
// best there.

#include <optional>
#include <string>
#include <vector>

#include "base/option.h"
#include "experiments/reporting/measure.h"
#include "experiments/reporting/report_context.h"

namespace gcslab {

struct ReportItem;

/// A value of the table, or its ratio to that of a method.
struct Quantity {
  ValueName value;
  std::string relative_to;  ///< empty: the value itself
};

/// What stands at one place of a table: the rows of one key, seen by one quantity.
struct TableEntry {
  AxisKey key;  ///< on the row axes, then on the column axes
  std::size_t quantity = 0;
  RowPointers rows;
  std::optional<Measure> measure;
  bool best = false;
};

class TableEntries {
 public:
  /// Throws InputError when the item cannot be a table of these rows.
  TableEntries(const ReportItem& item, const ReportContext& context);

  const RowPointers& rows() const { return rows_.all(); }
  const std::vector<std::string>& axes() const { return axes_; }
  bool has_axis(const std::string& axis) const;
  const std::vector<AxisKey>& row_keys() const { return row_keys_; }
  const std::vector<AxisKey>& column_keys() const { return column_keys_; }
  const std::vector<Quantity>& quantities() const { return quantities_; }
  const std::vector<TableEntry>& all() const { return entries_; }
  const TableEntry& at(std::size_t quantity, std::size_t row, std::size_t column) const;

 private:
  void list_quantities(const ReportItem& item, const std::string& reference);
  void measure_all();
  std::optional<Measure> measure_of(const AxisKey& key, const Quantity& quantity) const;
  AxisKey with_method(AxisKey key, const std::string& method) const;
  /// Marks, among the methods that answer the same question, the one with the least (or greatest) median.
  /// Equal ones share the mark; where all are equal, or baselines, there is none. Other programs' figures
  /// take no part.
  void mark_best(const std::string& direction, const std::vector<std::string>& baselines);

  SelectedRows rows_;
  std::vector<std::string> axes_;
  std::vector<AxisKey> row_keys_;
  std::vector<AxisKey> column_keys_;
  std::vector<Quantity> quantities_;
  std::vector<TableEntry> entries_;  ///< quantity by quantity, row by row, column by column
};

const std::vector<OptionSpec>& table_option_specs();

/// The options of a table of cells, with defaults: relative_to, spread, layout. Throws InputError with the
/// item's place.
Options table_options(const ReportItem& item);

}  // namespace gcslab
