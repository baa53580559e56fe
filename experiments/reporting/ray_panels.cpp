// Figure kind ray_panels: pictures of surfaces by ray casting, one panel a problem and method.

#include <algorithm>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "experiments/reporting/figure_registry.h"
#include "experiments/reporting/measure.h"
#include "experiments/reporting/number_format.h"
#include "experiments/reporting/palette.h"

namespace gcslab {
namespace {

constexpr double kGap = 3;
constexpr double kTitleHeight = 5;
constexpr double kCountHeight = 4;
constexpr double kRowLabelWidth = 5;
constexpr double kMargin = 1;
constexpr double kWidestPanel = 60;

/// Values of a picture that are no brightness (experiments/tasks/ray_cast_task.cpp).
constexpr int kBackground = 0, kMissed = 256, kLate = 257;

/// A gnuplot expression for one channel, 0 red to 2 blue, of the pixel value in the third column.
std::string channel_expression(int channel) {
  const auto part = [channel](std::string_view colour) {
    return std::stoi(std::string(colour.substr(1 + 2 * static_cast<std::size_t>(channel), 2)), nullptr, 16);
  };
  return fmt::format("($3=={} ? 255 : $3=={} ? {} : $3=={} ? {} : $3)", kBackground, kMissed,
                     part(palette::kVermillion), kLate, part(palette::kBlue));
}

class RayPanels {
 public:
  explicit RayPanels(const FigureRequest& request)
      : request_(request), item_(request.item), row_axes_(item_.rows), column_axes_(item_.columns) {
    if (row_axes_.empty()) row_axes_ = {"problem"};
    if (column_axes_.empty()) column_axes_ = {"method"};
  }

  FigureScript draw() {
    figure_.width = width_from(request_.options);
    figure_.notes = notes_on_missing(request_.rows);
    lay_out();
    for (std::size_t line = 0; line < row_keys_.size(); ++line) {
      for (std::size_t column = 0; column < column_keys_.size(); ++column) draw_panel(line, column);
    }
    if (has_errors_) {
      figure_.notes.insert(
          figure_.notes.begin(),
          "Vermillion, missed: rays that hit the surface where the method finds nothing; blue, late: rays on "
          "which what it finds is not the first hit.");
    }
    return std::move(figure_);
  }

 private:
  void lay_out() {
    axes_ = row_axes_;
    axes_.insert(axes_.end(), column_axes_.begin(), column_axes_.end());
    check_groups(request_.rows, axes_, item_);
    row_keys_ = keys_on(request_.rows, row_axes_);
    column_keys_ = keys_on(request_.rows, column_axes_);
    const auto columns = static_cast<double>(column_keys_.size());
    const double room = figure_.width - 2 * kMargin - kRowLabelWidth - kGap * (columns - 1);
    side_ = std::min(room / columns, kWidestPanel);
    figure_.width = 2 * kMargin + kRowLabelWidth + columns * side_ + kGap * (columns - 1);
    figure_.height = kTitleHeight + static_cast<double>(row_keys_.size()) * (side_ + kCountHeight);
  }

  PanelBox box_of(std::size_t line, std::size_t column) const {
    const double top = figure_.height - kTitleHeight - static_cast<double>(line) * (side_ + kCountHeight);
    return {kMargin + kRowLabelWidth + static_cast<double>(column) * (side_ + kGap), top - side_, side_,
            side_};
  }

  static std::string joined(const std::vector<std::string>& axes, const AxisKey& key) {
    std::string text;
    for (std::size_t i = 0; i < key.size(); ++i) text += (i == 0 ? "" : ", ") + heading_of(axes[i], key[i]);
    return text;
  }

  void draw_panel(std::size_t line, std::size_t column) {
    AxisKey key = row_keys_[line];
    key.insert(key.end(), column_keys_[column].begin(), column_keys_[column].end());
    const RowPointers rows = rows_at(request_.rows, axes_, key);
    const PanelBox box = box_of(line, column);
    const std::string label = joined(row_axes_, row_keys_[line]);
    const std::string title = joined(column_axes_, column_keys_[column]);
    figure_.command("\n# " + label + " / " + title);
    if (column == 0)
      figure_.text(2, (box.bottom + box.top()) / 2, label, {"center", kTitleText, palette::kText, true});
    if (line == 0) figure_.text(box.centre(), box.top() + 2.2, title, {"center", kTitleText});
    const bool has_picture = !rows.empty() && rows.front()->has_result();
    const std::string below = has_picture    ? counts_text(*rows.front())
                              : rows.empty() ? "no such job"
                                             : outcome_word(*rows.front());
    figure_.text(box.centre(), box.bottom - kCountHeight / 2, below,
                 {"center", kSmallText, palette::kQuietText});
    figure_.place(box);
    figure_.command("unset border; unset xtics; unset ytics");
    figure_.command(has_picture ? plot_command(*rows.front())
                                : "set xrange [0:1]; set yrange [0:1]\nplot NaN");
    figure_.clear_texts();
  }

  std::string counts_text(const Row& row) {
    const auto count = [&row](const char* name) {
      return format_count(row.values.contains(name) ? row.values.at(name).get<double>() : 0) + " ";
    };
    if (!row.values.contains("missed")) return count("hits") + "hits, every ray proved";
    has_errors_ = true;
    return count("missed") + "missed, " + count("late") + "late";
  }

  std::string plot_command(const Row& row) {
    if (!row.artifact.is_object() || !row.artifact.contains("ray_picture")) {
      throw InputError(item_.where, "'" + item_.file +
                                        "': the rows hold no pictures; ray_panels is for the task ray_cast");
    }
    const Json& picture = row.artifact.at("ray_picture");
    std::string lines;
    for (const Json& text : picture.at("rows")) lines += text.get<std::string>() + "\n";
    const double last = picture.at("pixels").get<double>() - 0.5;
    return fmt::format(
        "set xrange [-0.5:{0}]; set yrange [-0.5:{0}]\nplot data matrix index {1} using 1:2:{2}:{3}:{4} with "
        "rgbimage",
        last, figure_.add_data(place_text(row), lines), channel_expression(0), channel_expression(1),
        channel_expression(2));
  }

  const FigureRequest& request_;
  const ReportItem& item_;
  std::vector<std::string> row_axes_, column_axes_, axes_;
  std::vector<AxisKey> row_keys_, column_keys_;
  FigureScript figure_;
  double side_ = 0;
  bool has_errors_ = false;
};

}  // namespace

FigureKind ray_panels_kind() {
  return {"ray_panels",
          "the pictures of the task ray_cast: one line of panels a row key, one panel a column key",
          {width_option("page")},
          [](const FigureRequest& request) { return RayPanels(request).draw(); }};
}

}  // namespace gcslab
