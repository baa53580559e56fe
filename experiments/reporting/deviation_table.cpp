// Table kind deviations: on how many jobs the value of a method is not that of a reference method.

#include <algorithm>
#include <fmt/format.h>

#include "base/error.h"
#include "experiments/reporting/measure.h"
#include "experiments/reporting/report_context.h"
#include "experiments/reporting/table_kind.h"
#include "experiments/runner/report_item.h"

namespace gcslab {
namespace {

class DeviationBuilder {
 public:
  DeviationBuilder(const ReportItem& item, const ReportContext& context, const TableKind& kind)
      : item_(item),
        context_(context),
        rows_(context, item),
        value_(item.values.front()),
        reference_(options_of(item, kind).word("reference")) {
    axes_ = item.rows;
    axes_.insert(axes_.end(), item.columns.begin(), item.columns.end());
    const auto is_reference = [&](const Row* row) { return row->at("method") == reference_; };
    if (item.values.size() != 1 || std::ranges::find(axes_, "method") == axes_.end())
      throw InputError(item.where, "a table of kind deviations has one value, and method among its axes");
    if (std::ranges::none_of(rows_.all(), is_reference))
      throw InputError(item.where, "reference: '" + reference_ + "' is no method of this table");
  }

  Table build() {
    table_.caption = item_.caption.empty() ? context_.title : item_.caption;
    table_.head_names = item_.rows;
    table_.record_axes = axes_;
    const std::vector<AxisKey> columns = keys_on(rows_.all(), item_.columns);
    for (const AxisKey& column : columns) {
      table_.column_heads.emplace_back();
      for (std::size_t i = 0; i < column.size(); ++i)
        table_.column_heads.back().push_back(heading_of(item_.columns[i], column[i]));
    }
    if (item_.columns.empty()) table_.column_heads = {{"jobs"}};
    TableBlock block;
    for (const AxisKey& key : keys_on(rows_.all(), item_.rows)) block.lines.push_back(line_of(key, columns));
    table_.blocks.push_back(std::move(block));
    table_.notes.push_back("Jobs on which " + value_.heading() + " is not that of " + reference_ +
                           ", of those on which both have a result.");
    return std::move(table_);
  }

 private:
  TableLine line_of(const AxisKey& line_key, const std::vector<AxisKey>& columns) {
    TableLine line;
    for (std::size_t i = 0; i < line_key.size(); ++i)
      line.heads.push_back(heading_of(item_.rows[i], line_key[i]));
    for (const AxisKey& column : columns) {
      AxisKey key = line_key;
      key.insert(key.end(), column.begin(), column.end());
      line.cells.push_back(cell_of(key));
    }
    return line;
  }

  TableCell cell_of(const AxisKey& key) {
    std::size_t compared = 0, differing = 0;
    for (const Row* row : rows_at(rows_.all(), axes_, key)) {
      const Row* other = counterpart(*row);
      if (!row->has_result() || other == nullptr || !other->has_result()) continue;
      ++compared;
      if (text_of(*row) != text_of(*other)) ++differing;
    }
    const auto count = static_cast<double>(differing);
    table_.records.push_back(
        {key, value_.text() + " deviates", "", "", count, count, count, compared, "", ""});
    TableCell cell;
    cell.text = compared == 0 ? "–" : fmt::format("{} of {}", differing, compared);
    return cell;
  }

  /// The job of the reference method that asks the same question.
  const Row* counterpart(const Row& row) const {
    std::map<std::string, std::string> axes = row.axes;
    axes["method"] = reference_;
    const auto found =
        std::ranges::find_if(rows_.all(), [&](const Row* other) { return other->axes == axes; });
    return found == rows_.all().end() ? nullptr : *found;
  }

  std::string text_of(const Row& row) const {
    const std::optional<Measure> found = measure({&row}, value_);
    if (!found) return "";
    return found->text.empty() ? fmt::format("{}", found->median) : found->text;
  }

  const ReportItem& item_;
  const ReportContext& context_;
  SelectedRows rows_;
  ValueName value_;
  std::string reference_;
  std::vector<std::string> axes_;
  Table table_;
};

}  // namespace

TableKind deviations_table_kind() {
  return {"deviations",
          "on how many jobs one value of each method is not that of a reference method",
          {{.name = "reference",
            .meaning = "label of the method that others are compared with",
            .default_value = std::string()}},
          [](const ReportItem& item, const ReportContext& context) {
            return DeviationBuilder(item, context, deviations_table_kind()).build();
          },
          true};
}

}  // namespace gcslab
