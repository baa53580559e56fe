#include "experiments/reporting/row_table.h"

#include <algorithm>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/atomic_file.h"
#include "base/error.h"
#include "experiments/runner/job_row.h"
#include "experiments/runner/report_item.h"
#include "experiments/tasks/task.h"

namespace gcslab {
namespace {

std::vector<std::string> distinct(const std::vector<std::string>& texts) {
  std::vector<std::string> result;
  for (const std::string& text : texts) {
    if (std::ranges::find(result, text) == result.end()) result.push_back(text);
  }
  return result;
}

std::vector<std::string> texts_on(const RowPointers& rows, const std::string& axis) {
  std::vector<std::string> texts;
  for (const Row* row : rows) texts.push_back(row->at(axis));
  return distinct(texts);
}

Row planned_row(const Job& job, const std::vector<std::string>& parameters) {
  Row row;
  row.job = job.id();
  row.axes = {{"problem", job.problem}, {"method", job.label}, {"seed", std::to_string(job.seed)}};
  for (const auto& [name, value] : job.parameters.values()) {
    const bool is_axis = std::ranges::find(parameters, name) != parameters.end();
    (is_axis ? row.axes : row.constants)[name] = to_string(value);
  }
  return row;
}

void fill(Row& row, const JobRow& found) {
  row.status = name_of(found.result.status);
  row.reason = found.result.reason;
  row.values = found.result.values;
  row.timings = found.result.timings;
  row.artifact = found.result.artifact;
  row.peak_rss_mb = found.peak_rss_mb;
  row.provenance = found.provenance;
}

Row load_row(Row row, const std::filesystem::path& file) {
  if (!std::filesystem::exists(file)) return row;
  try {
    fill(row, row_from_text(read_file(file)));
  } catch (const InputError& error) {
    row.status = kDamaged;
    row.reason = file.filename().string() + " " + error.what();
  }
  return row;
}

}  // namespace

RowTable::RowTable(std::vector<std::string> axes, std::vector<Row> rows)
    : axes_(std::move(axes)), rows_(std::move(rows)) {}

std::vector<std::string> RowTable::values_of(const std::string& axis) const {
  std::vector<std::string> texts;
  for (const Row& row : rows_) texts.push_back(row.at(axis));
  return distinct(texts);
}

RowTable load_rows(const std::vector<Job>& plan, const std::vector<std::string>& parameters,
                   const std::filesystem::path& jobs_folder) {
  std::vector<Row> rows;
  rows.reserve(plan.size());
  for (const Job& job : plan) {
    rows.push_back(load_row(planned_row(job, parameters), jobs_folder / (job.id() + ".json")));
  }
  std::vector<std::string> axes = {"problem", "method"};
  axes.insert(axes.end(), parameters.begin(), parameters.end());
  axes.emplace_back("seed");
  return {std::move(axes), std::move(rows)};
}

RowPointers select_rows(const RowTable& table, const ReportItem& item) {
  const auto is_shown = [&item](const Row& row) {
    return std::ranges::all_of(item.filter, [&row](const auto& entry) {
      return std::ranges::find(entry.second, row.at(entry.first)) != entry.second.end();
    });
  };
  RowPointers rows;
  for (const Row& row : table.rows()) {
    if (is_shown(row)) rows.push_back(&row);
  }
  if (rows.empty())
    throw InputError(item.where, "no job of the experiment passes the filter of '" + item.file + "'");
  return rows;
}

AxisKey key_of(const Row& row, const std::vector<std::string>& axes) {
  AxisKey key;
  for (const std::string& axis : axes) key.push_back(row.at(axis));
  return key;
}

std::vector<AxisKey> keys_on(const RowPointers& rows, const std::vector<std::string>& axes) {
  std::vector<std::vector<std::string>> order;
  order.reserve(axes.size());
  for (const std::string& axis : axes) order.push_back(texts_on(rows, axis));
  std::map<std::vector<std::ptrdiff_t>, AxisKey> sorted;
  for (const Row* row : rows) {
    const AxisKey key = key_of(*row, axes);
    std::vector<std::ptrdiff_t> rank;
    for (std::size_t i = 0; i < key.size(); ++i)
      rank.push_back(std::ranges::find(order[i], key[i]) - order[i].begin());
    sorted.emplace(rank, key);
  }
  std::vector<AxisKey> keys;
  keys.reserve(sorted.size());
  for (const auto& [rank, key] : sorted) keys.push_back(key);
  return keys;
}

RowPointers rows_at(const RowPointers& rows, const std::vector<std::string>& axes, const AxisKey& key) {
  RowPointers result;
  std::ranges::copy_if(rows, std::back_inserter(result),
                       [&](const Row* row) { return key_of(*row, axes) == key; });
  return result;
}

void check_groups(const RowPointers& rows, const std::vector<std::string>& axes, const ReportItem& item) {
  for (const AxisKey& key : keys_on(rows, axes)) {
    const RowPointers group = rows_at(rows, axes, key);
    for (const auto& [axis, text] : group.front()->axes) {
      if (axis == "seed" || texts_on(group, axis).size() == 1) continue;
      throw InputError(item.where,
                       fmt::format("several values of {} fall on one place of '{}': add {} to its rows or "
                                   "columns, or choose one by a filter",
                                   axis, item.file, axis));
    }
  }
}

std::string common_axes_text(const RowPointers& rows, const std::vector<std::string>& shown) {
  std::string text;
  if (rows.empty()) return text;
  for (const auto& [axis, value] : rows.front()->axes) {
    const bool is_shown = std::ranges::find(shown, axis) != shown.end();
    if (is_shown || axis == "seed" || texts_on(rows, axis).size() != 1) continue;
    text += (text.empty() ? "" : ", ") + heading_of(axis, value);
  }
  return text;
}

std::string heading_of(const std::string& axis, const std::string& text) {
  if (axis == "method") return text;
  if (axis == "problem") return text.substr(text.find_last_of('/') + 1);
  std::string name = axis;
  std::ranges::replace(name, '_', ' ');
  return name + " " + text;
}

}  // namespace gcslab
