#include "experiments/reporting/table.h"

#include <algorithm>
#include <fmt/format.h>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "experiments/reporting/number_format.h"
#include "experiments/reporting/report_context.h"
#include "experiments/reporting/table_entries.h"
#include "experiments/reporting/table_kind.h"
#include "experiments/runner/report_item.h"

namespace gcslab {
namespace {

class TableBuilder {
 public:
  TableBuilder(const ReportItem& item, const ReportContext& context)
      : item_(item), context_(context), options_(table_options(item)), entries_(item, context) {}

  Table build() {
    lay_out();
    write_notes();
    write_records();
    return std::move(table_);
  }

 private:
  // ---- cells ----

  std::string footnote_mark(const std::string& text) {
    for (const Footnote& note : table_.footnotes) {
      if (note.text == text) return note.mark;
    }
    const std::size_t number = table_.footnotes.size();
    std::string mark(1, static_cast<char>('a' + number % 26));
    if (number >= 26) mark += std::to_string(number / 26);
    table_.footnotes.push_back({mark, text});
    return mark;
  }

  void add_mark(TableCell& cell, const std::string& text) {
    const std::string mark = footnote_mark(text);
    if (cell.marks.find(mark) == std::string::npos) cell.marks += (cell.marks.empty() ? "" : ",") + mark;
  }

  static std::string outcome_text(const Row& row) {
    const std::string word = outcome_word(row);
    return row.reason.empty() ? word : word + ": " + row.reason;
  }

  /// All outcomes without a result, by name.
  void name_outcomes(TableCell& cell, const RowPointers& rows) {
    for (const Row* row : rows) {
      if (row->has_result()) continue;
      const std::string word = outcome_word(*row);
      if (cell.text.find(word) == std::string::npos) cell.text += (cell.text.empty() ? "" : ", ") + word;
      if (!row->reason.empty()) add_mark(cell, outcome_text(*row));
    }
  }

  TableCell cell_of(const TableEntry& e, const std::optional<Scale>& shared) {
    TableCell cell;
    if (e.rows.empty()) return {.text = "–", .spread = "", .best = false, .marks = ""};
    if (std::ranges::none_of(e.rows, [](const Row* row) { return row->has_result(); })) {
      name_outcomes(cell, e.rows);
      return cell;
    }
    const Scale scale = shared || !e.measure ? shared.value_or(Scale{}) : scale_for("s", {e.measure->median});
    cell.text = e.measure ? number_text(*e.measure, scale) : "–";
    if (!shared && e.measure) cell.text += " " + scale.unit;
    if (e.measure) cell.spread = spread_text(*e.measure, scale);
    cell.best = e.best;
    note_partial_groups(cell, e.rows);
    return cell;
  }

  /// A median over some of the seeds only, or without proof, must say so: job by job, or of many by numbers.
  void note_partial_groups(TableCell& cell, const RowPointers& rows) {
    constexpr std::size_t kMostNamed = 8;
    if (rows.size() > kMostNamed) return note_large_group(cell, rows);
    for (const Row* row : rows) {
      if (!row->has_result()) {
        add_mark(cell, fmt::format("without {} ({})", place_text(*row), outcome_text(*row)));
      } else if (row->status == "partial" && !row->reason.empty()) {
        add_mark(cell, "partial: " + row->reason);
      }
    }
  }

  void note_large_group(TableCell& cell, const RowPointers& rows) {
    std::map<std::string, std::size_t> missing;
    std::size_t with_reason = 0;
    for (const Row* row : rows) {
      if (!row->has_result()) ++missing[outcome_word(*row)];
      if (row->status == "partial" && !row->reason.empty()) ++with_reason;
    }
    for (const auto& [word, count] : missing)
      add_mark(cell, fmt::format("without {} of {} jobs ({})", count, rows.size(), word));
    if (with_reason > 0)
      add_mark(cell, fmt::format("partial with a reason: {} of {} jobs", with_reason, rows.size()));
  }

  /// Fractions and short decimals as they stand in the row.
  static std::string number_text(const Measure& m, const Scale& scale) {
    constexpr std::size_t kShort = 12;
    constexpr int kDigits = 3;
    const bool is_plain = m.text.size() <= kShort && m.text.find('e') == std::string::npos;
    if (!m.text.empty() && (!m.is_number() || is_plain)) return m.text;
    return format_number(m.median * scale.factor, m.text.empty() ? kDigits : 2 * kDigits);
  }

  std::string spread_text(const Measure& m, const Scale& scale) const {
    const std::string& kind = options_.word("spread");
    if (kind == "none" || m.samples < 2 || m.minimum == m.maximum) return "";
    const double low = kind == "range" ? m.minimum : m.lower_quartile;
    const double high = kind == "range" ? m.maximum : m.upper_quartile;
    return format_number(low * scale.factor) + "–" + format_number(high * scale.factor);
  }

  // ---- layout ----

  /// One unit for all cells of a quantity, where that leaves them short; none where they differ by several
  /// powers of ten: then each cell has its own.
  std::optional<Scale> scale_of(std::size_t quantity) {
    constexpr double kWidest = 2000;
    const Quantity& q = entries_.quantities()[quantity];
    if (!q.relative_to.empty()) return Scale{};
    std::vector<double> medians;
    for (const TableEntry& e : entries_.all()) {
      const bool is_positive = e.measure && e.measure->is_number() && e.measure->median > 0;
      if (e.quantity == quantity && is_positive) medians.push_back(e.measure->median);
    }
    if (medians.empty() || q.value.unit() != "s") return scale_for(q.value.unit(), medians);
    const auto [least, greatest] = std::ranges::minmax(medians);
    if (greatest > kWidest * least) return std::nullopt;
    return scale_for("s", medians);
  }

  std::string heading(std::size_t quantity, const std::optional<Scale>& scale) const {
    const Quantity& q = entries_.quantities()[quantity];
    if (!q.relative_to.empty()) return q.value.heading() + " relative to " + q.relative_to;
    const bool has_unit = scale && !scale->unit.empty();
    return has_unit ? q.value.heading() + " [" + scale->unit + "]" : q.value.heading();
  }

  std::vector<std::string> column_head(const AxisKey& key) const {
    std::vector<std::string> head;
    for (std::size_t i = 0; i < key.size(); ++i) head.push_back(heading_of(item_.columns[i], key[i]));
    return head;
  }

  TableLine line_head(const AxisKey& key) const {
    TableLine line;
    for (std::size_t i = 0; i < key.size(); ++i) {
      line.heads.push_back(item_.rows[i] == "problem" ? heading_of("problem", key[i]) : key[i]);
    }
    return line;
  }

  void lay_out() {
    table_.caption = item_.caption.empty() ? context_.title : item_.caption;
    for (std::string name : item_.rows) {
      std::ranges::replace(name, '_', ' ');
      table_.head_names.push_back(name);
    }
    const std::string& layout = options_.word("layout");
    const bool in_blocks = layout == "blocks" || (layout == "auto" && !item_.columns.empty());
    in_blocks ? lay_out_blocks() : lay_out_columns();
  }

  void lay_out_blocks() {
    for (const AxisKey& key : entries_.column_keys()) table_.column_heads.push_back(column_head(key));
    if (item_.columns.empty()) table_.column_heads = {{"value"}};
    for (std::size_t q = 0; q < entries_.quantities().size(); ++q) {
      const std::optional<Scale> scale = scale_of(q);
      TableBlock block{heading(q, scale), {}};
      for (std::size_t row = 0; row < entries_.row_keys().size(); ++row) {
        TableLine line = line_head(entries_.row_keys()[row]);
        for (std::size_t c = 0; c < entries_.column_keys().size(); ++c)
          line.cells.push_back(cell_of(entries_.at(q, row, c), scale));
        block.lines.push_back(std::move(line));
      }
      table_.blocks.push_back(std::move(block));
    }
  }

  void lay_out_columns() {
    std::vector<std::optional<Scale>> scales;
    for (std::size_t q = 0; q < entries_.quantities().size(); ++q) scales.push_back(scale_of(q));
    for (const AxisKey& key : entries_.column_keys()) {
      for (std::size_t q = 0; q < entries_.quantities().size(); ++q) {
        table_.column_heads.push_back(column_head(key));
        table_.column_heads.back().push_back(heading(q, scales[q]));
      }
    }
    TableBlock block;
    for (std::size_t row = 0; row < entries_.row_keys().size(); ++row) {
      TableLine line = line_head(entries_.row_keys()[row]);
      for (std::size_t c = 0; c < entries_.column_keys().size(); ++c) {
        for (std::size_t q = 0; q < entries_.quantities().size(); ++q)
          line.cells.push_back(cell_of(entries_.at(q, row, c), scales[q]));
      }
      block.lines.push_back(std::move(line));
    }
    table_.blocks.push_back(std::move(block));
  }

  // ---- what the reader must know ----

  void write_notes() {
    const std::string common = common_axes_text(entries_.rows(), entries_.axes());
    if (!common.empty()) note("In all cells: " + common + ".");
    for (const Quantity& quantity : entries_.quantities()) note_meaning(quantity);
    if (has_mark_of_best()) {
      note(std::string("Bold: ") + (item_.best == "min" ? "least" : "greatest") + " of the methods.");
    }
    note_baselines();
    note_comparison();
    for (const std::string& sentence : notes_on_references(context_, item_)) note(sentence);
  }

  void note(const std::string& sentence) { table_.notes.push_back(sentence); }

  void note_meaning(const Quantity& quantity) {
    for (const ValueInfo& info : context_.values) {
      if (!quantity.relative_to.empty() || info.name != quantity.value.numerator() || info.meaning.empty())
        continue;
      if (quantity.value.denominator().empty()) note(quantity.value.heading() + ": " + info.meaning + ".");
    }
  }

  bool has_mark_of_best() const {
    return std::ranges::any_of(entries_.all(), [](const TableEntry& e) { return e.best; });
  }

  void note_baselines() {
    std::string names;
    for (const std::string& label : context_.baselines) {
      const bool is_shown =
          std::ranges::any_of(entries_.rows(), [&](const Row* row) { return row->at("method") == label; });
      if (is_shown) names += (names.empty() ? "" : ", ") + label;
    }
    if (!names.empty()) note("Baseline, not rigorous, never marked as best: " + names + ".");
  }

  void note_comparison() {
    const auto of_machine = [](const Quantity& q) { return q.value.is_of_machine(); };
    const bool any = std::ranges::any_of(entries_.quantities(), of_machine);
    const bool all = std::ranges::all_of(entries_.quantities(), of_machine);
    if (!all)
      note("Counts and exact numbers are the same on every machine and compared exactly with the reference.");
    if (any) note(timing_note());
  }

  std::string timing_note() const {
    const std::string& kind = options_.word("spread");
    std::string spread = kind == "range" ? " (least–greatest)" : " (quartiles)";
    if (kind == "none") spread.clear();
    const bool over_seeds = !entries_.has_axis("seed") && keys_on(entries_.rows(), {"seed"}).size() > 1;
    const std::string over = over_seeds ? "seeds, each the median of its repetitions," : "repetitions";
    const std::string count = over_seeds ? "" : fmt::format("{} ", context_.repetitions);
    const std::string machine = machine_text(context_.rows);
    return fmt::format("Times and memory are medians{} over {}{} and hold for one machine{}.", spread, count,
                       over, machine.empty() ? "" : " (" + machine + ")");
  }

  // ---- raw numbers ----

  void write_records() {
    table_.record_axes = entries_.axes();
    for (const TableEntry& e : entries_.all()) table_.records.push_back(record_of(e));
  }

  TableRecord record_of(const TableEntry& e) const {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    const Quantity& quantity = entries_.quantities()[e.quantity];
    TableRecord record{e.key, quantity.value.text(), quantity.value.unit(), "", kNone, kNone, kNone, 0, "",
                       ""};
    if (!quantity.relative_to.empty()) {
      record.value += " relative to " + quantity.relative_to;
      record.unit.clear();
    }
    if (e.measure) {
      record.text = e.measure->text;
      record.samples = e.measure->samples;
      record.median = e.measure->median;
      record.minimum = e.measure->minimum;
      record.maximum = e.measure->maximum;
    }
    for (const Row* row : e.rows) append_outcome(record, *row);
    if (e.rows.empty()) record.status = "no_such_job";
    return record;
  }

  static void append_outcome(TableRecord& record, const Row& row) {
    if (record.status.find(row.status) == std::string::npos)
      record.status += (record.status.empty() ? "" : ";") + row.status;
    if (!row.reason.empty() && record.reason.find(row.reason) == std::string::npos) {
      record.reason += (record.reason.empty() ? "" : "; ") + row.reason;
    }
  }

  const ReportItem& item_;
  const ReportContext& context_;
  Options options_;
  TableEntries entries_;
  Table table_;
};

}  // namespace

TableKind cells_table_kind() {
  return {"cells", "values of the jobs, by axes", table_option_specs(),
          [](const ReportItem& item, const ReportContext& context) {
            return TableBuilder(item, context).build();
          },
          true};
}

std::vector<HeadingSpan> heading_spans(const Table& table, std::size_t level) {
  std::vector<HeadingSpan> spans;
  const auto& heads = table.column_heads;
  const bool is_last = !heads.empty() && level + 1 == heads.front().size();
  for (std::size_t column = 0; column < heads.size(); ++column) {
    bool joins = column > 0 && !is_last;
    for (std::size_t above = 0; joins && above <= level; ++above) {
      joins = heads[column][above] == heads[column - 1][above];
    }
    if (joins) {
      ++spans.back().columns;
    } else {
      spans.push_back({heads[column][level], 1});
    }
  }
  return spans;
}

}  // namespace gcslab
