// Figure kind cover_panels: one panel a problem and method, with the cells that the method kept.

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>

#include "base/error.h"
#include "experiments/reporting/cover_drawing.h"
#include "experiments/reporting/figure_registry.h"
#include "experiments/reporting/number_format.h"
#include "experiments/reporting/palette.h"

namespace gcslab {
namespace {

constexpr double kGap = 4.5;          // between panels side by side
constexpr double kTitleHeight = 4.5;  // above a line of panels
constexpr double kTicHeight = 4;      // numbers below a panel
constexpr double kCountHeight = 3.5;  // cell counts below these
constexpr double kLineGap = 2;        // between lines of panels
constexpr double kLeftMargin = 7;     // numbers beside the first panel
constexpr double kTicWidth = 4;       // numbers beside a panel that is not the first
constexpr double kRowLabelWidth = 5;  // the problem's name, upwards
constexpr double kRightMargin = 2;
constexpr double kTallestPage = 240;

/// The panels that stand side by side: some columns of one row key.
struct PanelLine {
  std::vector<const Row*> rows;  ///< null: no such job
  std::vector<std::string> titles;
  std::string label;
  std::vector<std::optional<CoverTree>> trees;
  double aspect = 0;  ///< height over width of the tallest panel
  bool has_titles = true;
};

class CoverPanels {
 public:
  explicit CoverPanels(const FigureRequest& request)
      : request_(request), item_(request.item), row_axes_(item_.rows), column_axes_(item_.columns) {
    if (row_axes_.empty() && column_axes_.empty()) column_axes_ = {"method"};
    if (row_axes_.empty() && column_axes_ == std::vector<std::string>{"method"}) row_axes_ = {"problem"};
  }

  FigureScript draw() {
    figure_.width = width_from(request_.options);
    figure_.notes = notes_on_missing(request_.rows);
    collect_lines();
    lay_out();
    for (std::size_t i = 0; i < lines_.size(); ++i) draw_line(lines_[i], tops_[i]);
    write_notes();
    return std::move(figure_);
  }

 private:
  // ---- which panels there are ----

  void collect_lines() {
    std::vector<std::string> axes = row_axes_;
    axes.insert(axes.end(), column_axes_.begin(), column_axes_.end());
    check_groups(request_.rows, axes, item_);
    const std::vector<AxisKey> columns = keys_on(request_.rows, column_axes_);
    const std::size_t per_line = panels_per_line(columns.size());
    for (const AxisKey& row_key : keys_on(request_.rows, row_axes_)) {
      for (std::size_t first = 0; first < columns.size(); first += per_line) {
        const std::size_t last = std::min(first + per_line, columns.size());
        const std::vector<AxisKey> part(columns.begin() + static_cast<std::ptrdiff_t>(first),
                                        columns.begin() + static_cast<std::ptrdiff_t>(last));
        lines_.push_back(line_of(axes, row_key, part));
        lines_.back().has_titles = lines_.size() == 1 || per_line < columns.size();
      }
    }
    columns_ = std::min(per_line, columns.size());
  }

  std::size_t panels_per_line(std::size_t count) const {
    const auto wanted = static_cast<std::size_t>(request_.options.integer("panels_per_line"));
    if (wanted > 0) return wanted;
    return even_line(count, figure_.width > kColumnWidth ? 5 : 2);
  }

  PanelLine line_of(const std::vector<std::string>& axes, const AxisKey& row_key,
                    const std::vector<AxisKey>& columns) {
    PanelLine line;
    line.label = joined(row_axes_, row_key);
    for (const AxisKey& column_key : columns) {
      AxisKey key = row_key;
      key.insert(key.end(), column_key.begin(), column_key.end());
      const RowPointers rows = rows_at(request_.rows, axes, key);
      line.rows.push_back(rows.empty() ? nullptr : rows.front());
      if (rows.size() > 1) draws_first_seed_ = true;
      line.titles.push_back(joined(column_axes_, column_key));
      line.trees.push_back(tree_of(line.rows.back()));
      if (line.trees.back()) line.aspect = std::max(line.aspect, panel_aspect(line.trees.back()->domain()));
    }
    if (line.aspect == 0) line.aspect = 1;
    return line;
  }

  static std::string joined(const std::vector<std::string>& axes, const AxisKey& key) {
    std::string text;
    for (std::size_t i = 0; i < key.size(); ++i) text += (i == 0 ? "" : ", ") + heading_of(axes[i], key[i]);
    return text;
  }

  std::optional<CoverTree> tree_of(const Row* row) const {
    if (row == nullptr || !row->has_result()) return std::nullopt;
    if (!row->artifact.is_object()) {
      throw InputError(item_.where,
                       "'" + item_.file + "': the rows hold no covers; cover_panels is for the task cover");
    }
    CoverTree tree = CoverTree::from_json(nlohmann::json(row->artifact));
    if (tree.domain().size() != 2) {
      throw InputError(item_.where, "'" + item_.file + "': " + row->at("problem") +
                                        " has not two variables; leave it out by a filter");
    }
    return tree;
  }

  // ---- where they stand ----

  void lay_out() {
    has_row_labels_ =
        std::ranges::any_of(lines_, [this](const PanelLine& l) { return l.label != lines_.front().label; });
    left_ = kLeftMargin + (has_row_labels_ ? kRowLabelWidth : 0);
    const bool inner_tics = std::ranges::any_of(lines_, [](const PanelLine& line) {
      for (std::size_t column = 1; column < line.trees.size(); ++column) {
        if (has_vertical_tics(line, column)) return true;
      }
      return false;
    });
    gap_ = inner_tics ? kGap + kTicWidth : kGap;
    const double room = figure_.width - left_ - kRightMargin - gap_ * static_cast<double>(columns_ - 1);
    // Few panels are not blown up: a square of 80 mm shows every cell of the eighth level.
    panel_width_ = std::min(room / static_cast<double>(columns_), 80.0);
    double depth = 0;  // from the top
    for (const PanelLine& line : lines_) {
      depth += line.has_titles ? kTitleHeight : 0.5;
      tops_.push_back(depth);
      depth += panel_width_ * line.aspect + kTicHeight + (shows_counts() ? kCountHeight : 0) + kLineGap;
    }
    figure_.width = left_ + kRightMargin + panel_width_ * static_cast<double>(columns_) +
                    gap_ * static_cast<double>(columns_ - 1);
    figure_.height = depth - kLineGap + 0.5;
    for (double& top : tops_) top = figure_.height - top;
  }

  /// A panel shares the numbers of the panel to its left where the upright range is the same.
  static bool has_vertical_tics(const PanelLine& line, std::size_t column) {
    if (!line.trees[column]) return false;
    if (column == 0 || !line.trees[column - 1]) return true;
    return line.trees[column]->domain()[1] != line.trees[column - 1]->domain()[1];
  }

  bool shows_counts() const { return request_.options.flag("counts"); }

  PanelBox box_of(const PanelLine& line, double top, std::size_t column) const {
    const auto& tree = line.trees[column];
    const double height = panel_width_ * (tree ? panel_aspect(tree->domain()) : line.aspect);
    return {left_ + static_cast<double>(column) * (panel_width_ + gap_), top - height, panel_width_, height};
  }

  // ---- panels ----

  void draw_line(const PanelLine& line, double top) {
    for (std::size_t column = 0; column < line.rows.size(); ++column) {
      const PanelBox box = box_of(line, top, column);
      figure_.command("\n# " + line.label + " / " + line.titles[column]);
      if (has_row_labels_ && column == 0) {
        figure_.text(2, (box.bottom + box.top()) / 2, line.label,
                     {"center", kTitleText, palette::kText, true});
      }
      if (line.has_titles) {
        figure_.text(box.centre(), box.top() + 2.2, line.titles[column], {"center", kTitleText});
      }
      line.trees[column] ? draw_panel(line, column, box) : draw_outcome(line.rows[column], box);
      figure_.clear_texts();
    }
  }

  void draw_panel(const PanelLine& line, std::size_t column, const PanelBox& box) {
    const CoverTree& tree = *line.trees[column];
    const Row& row = *line.rows[column];
    if (shows_counts()) {
      figure_.text(box.centre(), box.bottom - kTicHeight - kCountHeight / 2, counts_text(row, tree),
                   {"center", kSmallText, palette::kQuietText});
    }
    CoverStyle style;
    style.visited = request_.options.flag("visited");
    style.curve = request_.options.flag("curve");
    style.vertical_tics = has_vertical_tics(line, column);
    draw_cover(figure_, box, tree, style.curve ? curve_of(row.at("problem")) : std::vector<Polyline>{}, style,
               place_text(row));
  }

  std::string counts_text(const Row& row, const CoverTree& tree) const {
    const auto count = [&row](const char* name, std::uint64_t otherwise) {
      return format_count(row.values.contains(name) && row.values.at(name).is_number()
                              ? row.values.at(name).get<double>()
                              : static_cast<double>(otherwise));
    };
    const std::string kept = count("kept_cells", tree.kept_cells());
    const std::string visited = count("visited_cells", tree.visited_cells());
    const std::string words = "kept " + kept + " of " + visited + " visited";
    return text_width(words) <= panel_width_ + gap_ ? words : kept + " of " + visited;
  }

  const std::vector<Polyline>& curve_of(const std::string& problem) {
    const auto known = curves_.find(problem);
    if (known != curves_.end()) return known->second;
    return curves_[problem] =
               request_.context.curve ? request_.context.curve(problem) : std::vector<Polyline>{};
  }

  void draw_outcome(const Row* row, const PanelBox& box) {
    std::string words = row == nullptr ? "no such job" : outcome_word(*row);
    if (row != nullptr && !row->reason.empty()) words += ": " + row->reason;
    std::vector<std::string> lines = wrapped(words, box.width - 2);
    constexpr std::size_t kMost = 8;
    if (lines.size() > kMost) {
      lines.resize(kMost);
      lines.back() += " …";
    }
    double y = (box.bottom + box.top()) / 2 + 1.6 * static_cast<double>(lines.size() - 1);
    for (const std::string& text : lines) {
      figure_.text(box.centre(), y, text, {"center", kSmallText, palette::kQuietText});
      y -= 3.2;
    }
    figure_.place(box);
    figure_.command("set xtics ('' -1); set ytics ('' -1)\nset xrange [0:1]; set yrange [0:1]\nplot NaN");
  }

  void write_notes() {
    std::string key = "Orange: cells kept";
    if (request_.options.flag("visited")) key += "; grey: borders of the cells that were visited and dropped";
    if (request_.options.flag("curve")) key += "; black: the curve";
    figure_.notes.insert(figure_.notes.begin(), key + ".");
    if (shows_counts()) figure_.notes.push_back("Below each panel: cells kept of cells visited.");
    if (draws_first_seed_) figure_.notes.emplace_back("Of several seeds the first is drawn.");
    if (figure_.height > kTallestPage) {
      figure_.notes.push_back(
          fmt::format("This figure is {:.0f} mm high, more than a page.", figure_.height));
    }
  }

  const FigureRequest& request_;
  const ReportItem& item_;
  std::vector<std::string> row_axes_;     ///< problem where the item names none
  std::vector<std::string> column_axes_;  ///< method where the item names none
  FigureScript figure_;
  std::vector<PanelLine> lines_;
  std::vector<double> tops_;
  std::size_t columns_ = 1;
  double left_ = 0;
  double gap_ = kGap;
  double panel_width_ = 0;
  bool has_row_labels_ = false;
  bool draws_first_seed_ = false;
  std::map<std::string, std::vector<Polyline>> curves_;
};

}  // namespace

FigureKind cover_panels_kind() {
  return {
      "cover_panels",
      "the cells that covers kept: one line of panels a row key, one panel a column key",
      {{.name = "visited",
        .meaning = "outline the cells that were visited and dropped",
        .default_value = true},
       {.name = "curve", .meaning = "draw the true curve over the cells", .default_value = true},
       {.name = "counts", .meaning = "print the numbers of cells below each panel", .default_value = true},
       {.name = "panels_per_line",
        .meaning = "panels side by side; 0: up to 5, lines of equal length",
        .default_value = std::int64_t{0},
        .minimum = 0,
        .maximum = 12},
       width_option("page")},
      [](const FigureRequest& request) { return CoverPanels(request).draw(); }};
}

}  // namespace gcslab
