#include "experiments/reporting/table_entries.h"

#include <algorithm>

#include "base/error.h"
#include "experiments/reporting/table_kind.h"
#include "experiments/runner/report_item.h"

namespace gcslab {

const std::vector<OptionSpec>& table_option_specs() {
  static const std::vector<OptionSpec> options = {
      {.name = "relative_to",
       .meaning = "method to which ratios of every number are added",
       .default_value = ""},
      {.name = "spread",
       .meaning = "what follows a median",
       .default_value = "range",
       .choices = {"range", "quartiles", "none"}},
      {.name = "layout",
       .meaning = "where several values stand; auto: blocks of lines when there are column axes",
       .default_value = "auto",
       .choices = {"auto", "blocks", "columns"}}};
  return options;
}

namespace {

void mark_best_of(const std::vector<TableEntry*>& rivals, bool least_is_best) {
  const auto by_median = [](const TableEntry* a, const TableEntry* b) {
    return a->measure->median < b->measure->median;
  };
  const auto [least, greatest] = std::ranges::minmax_element(rivals, by_median);
  const double lowest = (*least)->measure->median;
  const double highest = (*greatest)->measure->median;
  if (lowest == highest) return;  // nothing to tell apart
  for (TableEntry* entry : rivals) entry->best = entry->measure->median == (least_is_best ? lowest : highest);
}

}  // namespace

Options table_options(const ReportItem& item) { return options_of(item, table_kinds().at("cells")); }

TableEntries::TableEntries(const ReportItem& item, const ReportContext& context)
    : rows_(context, item), axes_(item.rows) {
  axes_.insert(axes_.end(), item.columns.begin(), item.columns.end());
  check_groups(rows(), axes_, item);
  row_keys_ = keys_on(rows(), item.rows);
  column_keys_ = keys_on(rows(), item.columns);
  list_quantities(item, table_options(item).word("relative_to"));
  measure_all();
  if (!item.best.empty() && has_axis("method")) mark_best(item.best, context.baselines);
}

bool TableEntries::has_axis(const std::string& axis) const {
  return std::ranges::find(axes_, axis) != axes_.end();
}

const TableEntry& TableEntries::at(std::size_t quantity, std::size_t row, std::size_t column) const {
  return entries_[(quantity * row_keys_.size() + row) * column_keys_.size() + column];
}

void TableEntries::list_quantities(const ReportItem& item, const std::string& reference) {
  for (const std::string& name : item.values) quantities_.push_back({ValueName(name), ""});
  if (reference.empty()) return;
  const bool is_shown =
      std::ranges::any_of(rows(), [&](const Row* row) { return row->at("method") == reference; });
  if (!has_axis("method") || !is_shown) {
    throw InputError(item.where, "relative_to: '" + reference + "' is no method of this table");
  }
  for (const std::string& name : item.values) quantities_.push_back({ValueName(name), reference});
}

void TableEntries::measure_all() {
  for (std::size_t quantity = 0; quantity < quantities_.size(); ++quantity) {
    for (const AxisKey& row_key : row_keys_) {
      for (const AxisKey& column_key : column_keys_) {
        AxisKey key = row_key;
        key.insert(key.end(), column_key.begin(), column_key.end());
        entries_.push_back(
            {key, quantity, rows_at(rows(), axes_, key), measure_of(key, quantities_[quantity]), false});
      }
    }
  }
}

std::optional<Measure> TableEntries::measure_of(const AxisKey& key, const Quantity& quantity) const {
  std::optional<Measure> found = measure(rows_at(rows(), axes_, key), quantity.value);
  if (quantity.relative_to.empty() || !found) return found;
  const auto reference =
      measure(rows_at(rows(), axes_, with_method(key, quantity.relative_to)), quantity.value);
  if (!found->is_number() || !reference || !reference->is_number() || reference->median == 0)
    return std::nullopt;
  return summarise({found->median / reference->median});
}

AxisKey TableEntries::with_method(AxisKey key, const std::string& method) const {
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    if (axes_[i] == "method") key[i] = method;
  }
  return key;
}

void TableEntries::mark_best(const std::string& direction, const std::vector<std::string>& baselines) {
  std::map<std::pair<std::size_t, AxisKey>, std::vector<TableEntry*>> questions;
  for (TableEntry& entry : entries_) {
    if (!entry.measure || !entry.measure->is_number() || entry.rows.front()->is_reference) continue;
    if (std::ranges::find(baselines, entry.rows.front()->at("method")) != baselines.end()) continue;
    questions[{entry.quantity, with_method(entry.key, "")}].push_back(&entry);
  }
  for (auto& [question, rivals] : questions) mark_best_of(rivals, direction == "min");
}

}  // namespace gcslab
