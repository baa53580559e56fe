#include "experiments/reporting/panel_grid.h"

#include <algorithm>
#include <fmt/format.h>

#include "base/error.h"
#include "experiments/reporting/palette.h"
#include "experiments/reporting/plane_drawing.h"

namespace gcslab {
namespace {

constexpr double kGap = 4.5;          // between panels side by side
constexpr double kTitleHeight = 4.5;  // above a line of panels
constexpr double kTicHeight = 4;      // numbers below a panel
constexpr double kCountHeight = 3.5;  // counts below these
constexpr double kLineGap = 2;        // between lines of panels
constexpr double kLeftMargin = 7;     // numbers beside the first panel
constexpr double kTicWidth = 4;       // numbers beside a panel that is not the first
constexpr double kRowLabelWidth = 5;  // the row's name, upwards
constexpr double kRightMargin = 2;
constexpr double kTallestPage = 240;
constexpr double kTicGap = 2;       // from a number to its panel
constexpr double kTitleLine = 3.2;  // from one line of a title to the next

/// A title in one line, or in two where it is too wide: broken after the space or hyphen nearest to its
/// middle.
std::vector<std::string> title_lines(const std::string& title, double room) {
  if (text_width(title, kTitleText) <= room) return {title};
  std::size_t best = 0;
  const auto distance = [&](std::size_t at) {
    return at > title.size() / 2 ? at - title.size() / 2 : title.size() / 2 - at;
  };
  for (std::size_t i = 1; i + 1 < title.size(); ++i) {
    if ((title[i] == ' ' || title[i] == '-') && (best == 0 || distance(i) < distance(best))) best = i;
  }
  if (best == 0) return {title};
  const std::size_t end = title[best] == '-' ? best + 1 : best;
  return {title.substr(0, end), title.substr(best + 1)};
}

}  // namespace

PanelGrid::PanelGrid(const FigureRequest& request)
    : request_(request), item_(request.item), row_axes_(item_.rows), column_axes_(item_.columns) {
  if (row_axes_.empty() && column_axes_.empty()) column_axes_ = {"method"};
  if (row_axes_.empty() && column_axes_ == std::vector<std::string>{"method"}) row_axes_ = {"problem"};
}

FigureScript PanelGrid::draw() {
  figure_.width = width_from(request_.options);
  figure_.notes = notes_on_missing(request_.rows);
  collect_lines();
  lay_out();
  for (std::size_t i = 0; i < lines_.size(); ++i) draw_line(lines_[i], tops_[i]);
  write_notes();
  return std::move(figure_);
}

void PanelGrid::fail(const std::string& message) const {
  throw InputError(item_.where, "'" + item_.file + "': " + message);
}

// ---- which panels there are ----

void PanelGrid::collect_lines() {
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

std::size_t PanelGrid::panels_per_line(std::size_t count) const {
  const auto wanted = static_cast<std::size_t>(request_.options.integer("panels_per_line"));
  if (wanted > 0) return wanted;
  return even_line(count, figure_.width > kColumnWidth ? 5 : 2);
}

PanelGrid::Line PanelGrid::line_of(const std::vector<std::string>& axes, const AxisKey& row_key,
                                   const std::vector<AxisKey>& columns) {
  Line line;
  line.label = joined(row_axes_, row_key);
  for (const AxisKey& column_key : columns) {
    AxisKey key = row_key;
    key.insert(key.end(), column_key.begin(), column_key.end());
    const RowPointers rows = rows_at(request_.rows, axes, key);
    const Row* row = rows.empty() ? nullptr : rows.front();
    if (rows.size() > 1) draws_first_seed_ = true;
    line.rows.push_back(row);
    line.titles.push_back(joined(column_axes_, column_key));
    line.domains.emplace_back();
    if (row == nullptr || !row->has_result()) continue;
    line.domains.back() = domain_of(*row);
    line.aspect = std::max(line.aspect, panel_aspect(*line.domains.back()));
  }
  if (line.aspect == 0) line.aspect = 1;
  return line;
}

std::string PanelGrid::joined(const std::vector<std::string>& axes, const AxisKey& key) {
  std::string text;
  for (std::size_t i = 0; i < key.size(); ++i) text += (i == 0 ? "" : ", ") + heading_of(axes[i], key[i]);
  return text;
}

// ---- where they stand ----

void PanelGrid::lay_out() {
  has_row_labels_ =
      std::ranges::any_of(lines_, [this](const Line& l) { return l.label != lines_.front().label; });
  left_ = std::max(kLeftMargin, number_width() + kTicGap) + (has_row_labels_ ? kRowLabelWidth : 0);
  const bool inner_tics = std::ranges::any_of(lines_, [](const Line& line) {
    for (std::size_t column = 1; column < line.domains.size(); ++column) {
      if (has_vertical_tics(line, column)) return true;
    }
    return false;
  });
  gap_ = inner_tics ? kGap + kTicWidth : kGap;
  const double room = figure_.width - left_ - kRightMargin - gap_ * static_cast<double>(columns_ - 1);
  // Few panels are not blown up: a square of 80 mm shows every cell of the eighth level.
  panel_width_ = std::min(room / static_cast<double>(columns_), 80.0);
  double depth = 0;  // from the top
  for (const Line& line : lines_) {
    depth += title_height(line);
    tops_.push_back(depth);
    depth += panel_width_ * line.aspect + kTicHeight + (shows_counts() ? kCountHeight : 0) + kLineGap;
  }
  figure_.width = left_ + kRightMargin + panel_width_ * static_cast<double>(columns_) +
                  gap_ * static_cast<double>(columns_ - 1);
  figure_.height = depth - kLineGap + 0.5;
  for (double& top : tops_) top = figure_.height - top;
}

double PanelGrid::title_height(const Line& line) const {
  if (!line.has_titles) return 0.5;
  const auto is_wide = [&](const std::string& title) {
    return title_lines(title, panel_width_ + gap_).size() > 1;
  };
  return kTitleHeight + (std::ranges::any_of(line.titles, is_wide) ? kTitleLine : 0);
}

/// Of the numbers beside the first panels.
double PanelGrid::number_width() const {
  double widest = 0;
  for (const Line& line : lines_) {
    if (line.domains.empty() || !line.domains.front()) continue;
    const Interval& side = (*line.domains.front())[1];
    for (const double number : {side.lower, midpoint(side), side.upper})
      widest = std::max(widest, text_width(fmt::format("{:.3g}", number)));
  }
  return widest;
}

/// A panel shares the numbers of the panel to its left where the upright range is the same.
bool PanelGrid::has_vertical_tics(const Line& line, std::size_t column) {
  if (!line.domains[column]) return false;
  if (column == 0 || !line.domains[column - 1]) return true;
  return (*line.domains[column])[1] != (*line.domains[column - 1])[1];
}

PanelBox PanelGrid::box_of(const Line& line, double top, std::size_t column) const {
  const auto& domain = line.domains[column];
  const double height = panel_width_ * (domain ? panel_aspect(*domain) : line.aspect);
  return {left_ + static_cast<double>(column) * (panel_width_ + gap_), top - height, panel_width_, height};
}

// ---- panels ----

void PanelGrid::draw_line(const Line& line, double top) {
  for (std::size_t column = 0; column < line.rows.size(); ++column) {
    const PanelBox box = box_of(line, top, column);
    figure_.command("\n# " + line.label + " / " + line.titles[column]);
    if (has_row_labels_ && column == 0) {
      figure_.text(2, (box.bottom + box.top()) / 2, line.label, {"center", kTitleText, palette::kText, true});
    }
    if (line.has_titles) write_title(box, line.titles[column]);
    if (line.domains[column]) {
      const Row& row = *line.rows[column];
      if (shows_counts()) {
        figure_.text(box.centre(), box.bottom - kTicHeight - kCountHeight / 2,
                     counts_text(row, panel_width_ + gap_), {"center", kSmallText, palette::kQuietText});
      }
      draw_panel(row, box, has_vertical_tics(line, column));
    } else {
      draw_outcome(line.rows[column], box);
    }
    figure_.clear_texts();
  }
}

void PanelGrid::write_title(const PanelBox& box, const std::string& title) {
  const std::vector<std::string> lines = title_lines(title, panel_width_ + gap_);
  double y = box.top() + 2.2 + kTitleLine * static_cast<double>(lines.size() - 1);
  for (const std::string& line : lines) {
    figure_.text(box.centre(), y, line, {"center", kTitleText});
    y -= kTitleLine;
  }
}

void PanelGrid::draw_outcome(const Row* row, const PanelBox& box) {
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

void PanelGrid::write_notes() {
  const std::vector<std::string> first = leading_notes();
  figure_.notes.insert(figure_.notes.begin(), first.begin(), first.end());
  const std::vector<std::string> last = closing_notes();
  figure_.notes.insert(figure_.notes.end(), last.begin(), last.end());
  if (draws_first_seed_) figure_.notes.emplace_back("Of several seeds the first is drawn.");
  if (figure_.height > kTallestPage) {
    figure_.notes.push_back(fmt::format("This figure is {:.0f} mm high, more than a page.", figure_.height));
  }
}

OptionSpec panels_per_line_option() {
  return {.name = "panels_per_line",
          .meaning = "panels side by side; 0: up to 5, lines of equal length",
          .default_value = std::int64_t{0},
          .minimum = 0,
          .maximum = 12};
}

}  // namespace gcslab
