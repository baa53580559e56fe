// Table kind counts: how often each text or number of a value occurs among the jobs of a line.

#include <algorithm>
#include <limits>
#include <map>

#include "base/error.h"
#include "experiments/reporting/measure.h"
#include "experiments/reporting/number_format.h"
#include "experiments/reporting/report_context.h"
#include "experiments/reporting/table_kind.h"
#include "experiments/runner/report_item.h"

namespace gcslab {
namespace {

class CountsBuilder {
 public:
  CountsBuilder(const ReportItem& item, const ReportContext& context)
      : item_(item), context_(context), rows_(context, item), value_(item.values.front()) {
    if (item.values.size() != 1 || !item.columns.empty() || !item.best.empty())
      throw InputError(item.where, "a table of kind counts has one value, and neither columns nor best");
    const auto spelt_before = [](const std::string& a, const std::string& b) {
      const auto x = number_from_text(a), y = number_from_text(b);
      return x && y ? *x < *y : a < b;
    };
    for (const Row* row : rows_.all()) texts_.push_back(text_of(*row));
    std::ranges::sort(texts_, spelt_before);
    texts_.erase(std::unique(texts_.begin(), texts_.end()), texts_.end());
  }

  Table build() {
    table_.caption = item_.caption.empty() ? context_.title : item_.caption;
    table_.head_names = item_.rows;
    table_.record_axes = item_.rows;
    for (const std::string& text : texts_) table_.column_heads.push_back({words_of(text)});
    TableBlock block;
    for (const AxisKey& key : keys_on(rows_.all(), item_.rows)) block.lines.push_back(line_of(key));
    table_.blocks.push_back(std::move(block));
    table_.notes.push_back("Numbers of jobs, by " + value_.heading() + ".");
    for (const ValueInfo& info : context_.values) {
      if (info.name == value_.text()) table_.notes.push_back(value_.heading() + ": " + info.meaning + ".");
    }
    return std::move(table_);
  }

 private:
  /// The value, or the outcome of a job without one.
  std::string text_of(const Row& row) const {
    const std::optional<Measure> found = measure({&row}, value_);
    if (!found) return outcome_word(row);
    return found->text.empty() ? format_number(found->median) : found->text;
  }

  static std::string words_of(std::string text) {
    std::ranges::replace(text, '_', ' ');
    return text;
  }

  TableLine line_of(const AxisKey& key) {
    TableLine line;
    for (std::size_t i = 0; i < key.size(); ++i) line.heads.push_back(heading_of(item_.rows[i], key[i]));
    std::map<std::string, std::size_t> counts;
    for (const Row* row : rows_at(rows_.all(), item_.rows, key)) ++counts[text_of(*row)];
    for (const std::string& text : texts_) {
      TableCell cell;
      cell.text = counts.contains(text) ? std::to_string(counts[text]) : "–";
      line.cells.push_back(std::move(cell));
      const auto count = static_cast<double>(counts[text]);
      table_.records.push_back({key, value_.text() + " = " + text, "", "", count, count, count, 1, "", ""});
    }
    return line;
  }

  const ReportItem& item_;
  const ReportContext& context_;
  SelectedRows rows_;
  ValueName value_;
  std::vector<std::string> texts_;
  Table table_;
};

}  // namespace

TableKind counts_table_kind() {
  return {"counts",
          "how often each number or text of one value occurs among the jobs of a line",
          {},
          [](const ReportItem& item, const ReportContext& context) {
            return CountsBuilder(item, context).build();
          },
          true};
}

}  // namespace gcslab
