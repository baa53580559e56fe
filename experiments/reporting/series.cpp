// Figure kind series: values against a number, one line a column key, one panel a row key and value.

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "base/error.h"
#include "experiments/reporting/figure_registry.h"
#include "experiments/reporting/legend.h"
#include "experiments/reporting/measure.h"
#include "experiments/reporting/number_format.h"
#include "experiments/reporting/palette.h"
#include "experiments/reporting/plot_axis.h"
#include "experiments/reporting/power_law.h"

namespace gcslab {
namespace {

constexpr double kLabelWidth = 4.5;  // the upright axis label
constexpr double kGap = 4;
constexpr double kTitleHeight = 5;
constexpr double kAxisHeight = 8.5;  // numbers and label below a panel
constexpr double kRightMargin = 3;

struct SeriesPoint {
  double x = 0;
  Measure y;
};

struct SeriesPanel {
  std::string title;
  ValueName value;
  std::vector<std::vector<SeriesPoint>> lines;  ///< one a column key
};

class SeriesFigure {
 public:
  explicit SeriesFigure(const FigureRequest& request)
      : request_(request),
        item_(request.item),
        x_(x_name()),
        x_is_axis_(is_axis(x_.text())),
        column_axes_(request.item.columns) {
    is_logarithmic_y_ = request.options.flag("logy");
    if (column_axes_.empty()) column_axes_ = {"method"};
    shares_y_ = request.options.flag("same_y") && item_.values.size() == 1;
  }

  FigureScript draw() {
    figure_.width = width_from(request_.options);
    collect();
    lay_out();
    for (std::size_t i = 0; i < panels_.size(); ++i) draw_panel(i);
    write_notes();
    return std::move(figure_);
  }

 private:
  [[noreturn]] void fail(const std::string& message) const {
    throw InputError(item_.where, "'" + item_.file + "': " + message);
  }

  bool is_axis(const std::string& name) const {
    return std::ranges::find(request_.context.rows.axes(), name) != request_.context.rows.axes().end();
  }

  ValueName x_name() const {
    const std::string& name = request_.options.word("x");
    if (name.empty())
      fail("a series needs the option x: the axis or value that its points are drawn against");
    return ValueName(name);
  }

  // ---- points ----

  void collect() {
    if (item_.values.empty()) fail("a series needs values");
    std::vector<std::string> axes = item_.rows;
    axes.insert(axes.end(), column_axes_.begin(), column_axes_.end());
    if (x_is_axis_) {
      axes.push_back(x_.text());
      check_groups(request_.rows, axes, item_);
    }
    line_keys_ = keys_on(request_.rows, column_axes_);
    for (const std::string& value : item_.values) {
      for (const AxisKey& key : keys_on(request_.rows, item_.rows)) panels_.push_back(panel_of(value, key));
    }
    for (const AxisKey& key : line_keys_) line_names_.push_back(joined(column_axes_, key));
  }

  SeriesPanel panel_of(const std::string& value, const AxisKey& key) const {
    SeriesPanel panel{joined(item_.rows, key), ValueName(value), {}};
    if (item_.values.size() > 1) panel.title += (panel.title.empty() ? "" : ", ") + panel.value.heading();
    const RowPointers rows = rows_at(request_.rows, item_.rows, key);
    for (const AxisKey& line : line_keys_) {
      panel.lines.push_back(points_of(rows_at(rows, column_axes_, line), panel.value));
    }
    return panel;
  }

  /// One point for each group of rows that differ in nothing but the seed.
  std::vector<SeriesPoint> points_of(const RowPointers& rows, const ValueName& value) const {
    std::vector<std::string> axes;
    for (const std::string& axis : request_.context.rows.axes()) {
      if (axis != "seed") axes.push_back(axis);
    }
    if (x_.text() == "seed") axes.emplace_back("seed");
    std::vector<SeriesPoint> points;
    for (const AxisKey& key : keys_on(rows, axes)) {
      const RowPointers group = rows_at(rows, axes, key);
      const auto y = measure(group, value);
      if (y && y->is_number() && std::isfinite(y->median)) points.push_back({x_of(group), *y});
    }
    std::ranges::sort(points, {}, &SeriesPoint::x);
    return points;
  }

  double x_of(const RowPointers& group) const {
    const auto x = measure(group, x_);
    if (!x || !x->is_number()) fail("x: '" + x_.text() + "' is no number in " + place_text(*group.front()));
    return x->median;
  }

  static std::string joined(const std::vector<std::string>& axes, const AxisKey& key) {
    std::string text;
    for (std::size_t i = 0; i < key.size(); ++i) text += (i == 0 ? "" : ", ") + heading_of(axes[i], key[i]);
    return text;
  }

  // ---- scales ----

  /// All numbers of panels that share a vertical axis with `panel`.
  std::vector<double> y_numbers(const SeriesPanel& panel) const {
    std::vector<double> numbers;
    for (const SeriesPanel& other : panels_) {
      if (&other != &panel && !shares_y_) continue;
      for (const auto& line : other.lines) {
        for (const SeriesPoint& point : line) {
          for (const double y : {point.y.minimum, point.y.median, point.y.maximum}) numbers.push_back(y);
        }
      }
    }
    return numbers;
  }

  Scale y_scale(const SeriesPanel& panel) const { return scale_for(panel.value.unit(), y_numbers(panel)); }

  PlotAxis y_axis(const SeriesPanel& panel) const {
    std::vector<double> numbers = y_numbers(panel);
    const double factor = y_scale(panel).factor;
    for (double& number : numbers) number *= factor;
    if (is_logarithmic_y_) return with_zero(logarithmic_axis(numbers), numbers);
    numbers.push_back(0);
    return linear_axis(numbers, 4);
  }

  /// Numbers that have no logarithm stand on the lower edge, apart from the others.
  static PlotAxis with_zero(PlotAxis axis, const std::vector<double>& numbers) {
    if (std::ranges::none_of(numbers, [](double number) { return number <= 0; })) return axis;
    axis.low /= 10;
    axis.tics.emplace_back(axis.low, "0");
    return axis;
  }

  PlotAxis x_axis() const {
    std::vector<double> numbers;
    for (const SeriesPanel& panel : panels_) {
      for (const auto& line : panel.lines) {
        for (const SeriesPoint& point : line) numbers.push_back(point.x);
      }
    }
    return request_.options.flag("logx") ? logarithmic_axis(numbers) : whole_number_axis(numbers);
  }

  // ---- layout ----

  bool has_titles() const {
    return std::ranges::any_of(panels_,
                               [this](const SeriesPanel& p) { return p.title != panels_.front().title; });
  }

  void lay_out() {
    const auto wanted = static_cast<std::size_t>(request_.options.integer("panels_per_line"));
    const std::size_t most = figure_.width > kColumnWidth ? 3 : 1;
    per_line_ = wanted > 0 ? std::min(panels_.size(), wanted) : even_line(panels_.size(), most);
    const auto columns = static_cast<double>(per_line_);
    for (const SeriesPanel& panel : panels_) numbers_ = std::max(numbers_, y_axis(panel).widest_number());
    left_ = kLabelWidth + numbers_ + 1.5;
    gap_ = kGap + (shares_y_ ? 0 : numbers_);
    panel_width_ = (figure_.width - left_ - kRightMargin - gap_ * (columns - 1)) / columns;
    panel_height_ = std::min(panel_width_ * 0.72, 60.0);
    title_height_ = has_titles() ? kTitleHeight : 1.5;
    const std::size_t lines = (panels_.size() + per_line_ - 1) / per_line_;
    legend_ = legend_height(line_names_, figure_.width);
    figure_.height =
        static_cast<double>(lines) * (title_height_ + panel_height_ + kAxisHeight) + legend_ + 0.5;
  }

  PanelBox box_of(std::size_t index) const {
    const auto column = static_cast<double>(index % per_line_);
    const std::size_t line = index / per_line_;
    const double top = figure_.height -
                       static_cast<double>(line) * (title_height_ + panel_height_ + kAxisHeight) -
                       title_height_;
    return {left_ + column * (panel_width_ + gap_), top - panel_height_, panel_width_, panel_height_};
  }

  // ---- drawing ----

  void draw_panel(std::size_t index) {
    const SeriesPanel& panel = panels_[index];
    const PanelBox box = box_of(index);
    const bool is_first = index % per_line_ == 0;
    figure_.command("\n# " + panel.title);
    if (has_titles()) figure_.text(box.left, box.top() + 2.2, title_of(panel), {"left", kTitleText});
    figure_.text(box.centre(), box.bottom - 6.3, x_label(), {"center"});
    if (is_first)
      figure_.text(2, (box.bottom + box.top()) / 2, y_label(panel), {"center", kSmallText, "#202020", true});
    if (index == 0) draw_legend(figure_, line_names_, left_, legend_);
    figure_.place(box);
    const PlotAxis y = y_axis(panel);
    figure_.command(x_axis().commands('x'));
    figure_.command(y.commands('y', is_first || !shares_y_));
    figure_.command(fmt::format("set grid ytics lt 1 lw 0.3 lc rgb '{}'", palette::kGrid));
    figure_.command("set border 3");
    figure_.command(plot_command(panel, y));
    figure_.clear_texts();
  }

  /// With its unit where the panels show several values: the upright label stands beside the first one only.
  std::string title_of(const SeriesPanel& panel) const {
    const std::string unit = y_scale(panel).unit;
    return item_.values.size() < 2 || unit.empty() ? panel.title : panel.title + " [" + unit + "]";
  }

  std::string x_label() const {
    const std::string& given = request_.options.word("x_label");
    if (!given.empty()) return given;
    const std::string unit = x_.unit();
    return unit.empty() ? x_.heading() : x_.heading() + " [" + unit + "]";
  }

  std::string y_label(const SeriesPanel& panel) const {
    const std::string& given = request_.options.word("y_label");
    if (!given.empty()) return given;
    const std::string unit = y_scale(panel).unit;
    return unit.empty() ? panel.value.heading() : panel.value.heading() + " [" + unit + "]";
  }

  std::string plot_command(const SeriesPanel& panel, const PlotAxis& y) {
    std::string bands;
    std::string lines;
    for (std::size_t i = 0; i < panel.lines.size(); ++i) {
      if (panel.lines[i].empty()) continue;
      const std::size_t block =
          figure_.add_data(panel.title + ", " + line_names_[i] + "; x, median, least, greatest",
                           data_lines(panel, panel.lines[i], y));
      const LineLook look = line_look(i);
      if (has_spread(panel.lines[i])) bands += spread_layer(block, look);
      lines += fmt::format(", \\\n  data index {} using 1:2 with linespoints pt {} ps 0.45 {}", block,
                           look.point_type, look.line_style());
    }
    if (request_.options.flag("fit")) lines += fit_layers(panel, y);
    const std::string layers = bands + lines;
    return layers.empty() ? "plot NaN" : "plot " + layers.substr(2);
  }

  /// A thin line for each line that has a power law, and its exponent among the notes.
  std::string fit_layers(const SeriesPanel& panel, const PlotAxis& y) {
    std::string layers;
    for (std::size_t i = 0; i < panel.lines.size(); ++i) {
      std::vector<std::pair<double, double>> numbers;
      for (const SeriesPoint& point : panel.lines[i]) numbers.emplace_back(point.x, point.y.median);
      const auto law = fitted_power_law(numbers);
      if (!law) continue;
      std::vector<SeriesPoint> ends;
      for (const double x : {law->from, law->to}) {
        const double value = law->at(x);
        ends.push_back({x, summarise({value})});
      }
      const std::size_t block =
          figure_.add_data("power law of " + line_names_[i], data_lines(panel, ends, y));
      layers += fmt::format(", \\\n  data index {} using 1:2 with lines lw 1 lc rgb '{}' dt 2", block,
                            line_look(i).colour);
      fits_.push_back(fmt::format("{}{}: {:.2f}", panel.title.empty() ? "" : panel.title + ", ",
                                  line_names_[i], law->exponent));
    }
    return layers;
  }

  std::string data_lines(const SeriesPanel& panel, const std::vector<SeriesPoint>& points,
                         const PlotAxis& y) {
    const double factor = y_scale(panel).factor;
    const auto drawn = [&](double number) {
      if (!is_logarithmic_y_ || number > 0) return plot_number(number * factor);
      has_zeros_ = true;
      return plot_number(y.low);
    };
    std::string lines;
    for (const SeriesPoint& p : points) {
      lines += fmt::format("{} {} {} {}\n", plot_number(p.x), drawn(p.y.median), drawn(p.y.minimum),
                           drawn(p.y.maximum));
    }
    return lines;
  }

  static bool has_spread(const std::vector<SeriesPoint>& points) {
    return std::ranges::any_of(points, [](const SeriesPoint& p) { return p.y.minimum < p.y.maximum; });
  }

  std::string spread_layer(std::size_t block, const LineLook& look) {
    const std::string& kind = request_.options.word("spread");
    if (kind == "none") return "";
    shows_spread_ = true;
    if (kind == "bars") {
      return fmt::format(", \\\n  data index {} using 1:3:(0):($4-$3) with vectors nohead lw 0.6 lc rgb '{}'",
                         block, look.colour);
    }
    return fmt::format(
        ", \\\n  data index {} using 1:3:4 with filledcurves fs transparent solid 0.18 noborder lc rgb '{}'",
        block, look.colour);
  }

  void write_notes() {
    const std::string over = keys_on(request_.rows, {"seed"}).size() > 1 ? "seeds" : "repetitions";
    if (shows_spread_) {
      const bool bars = request_.options.word("spread") == "bars";
      figure_.notes.push_back(
          fmt::format("Points: medians over {}; {}: least to greatest.", over, bars ? "bars" : "bands"));
    }
    if (!fits_.empty()) {
      std::string exponents;
      for (const std::string& fit : fits_) exponents += (exponents.empty() ? "" : "; ") + fit;
      figure_.notes.push_back("Dashed: powers of " + x_.heading() +
                              ", fitted to the upper half of its range, with exponents " + exponents + ".");
    }
    if (has_zeros_) figure_.notes.emplace_back("Points on the lower edge are 0 or less.");
    const std::string machine = machine_text(request_.context.rows);
    const bool timed =
        std::ranges::any_of(panels_, [](const SeriesPanel& p) { return p.value.is_of_machine(); });
    if (timed && !machine.empty()) figure_.notes.push_back("Measured on one machine (" + machine + ").");
    for (std::string& note : notes_on_missing(request_.rows)) figure_.notes.push_back(std::move(note));
  }

  const FigureRequest& request_;
  const ReportItem& item_;
  ValueName x_;
  bool x_is_axis_;
  std::vector<std::string> column_axes_;  ///< method where the item names none
  bool is_logarithmic_y_ = true;
  bool shares_y_ = true;
  FigureScript figure_;
  std::vector<SeriesPanel> panels_;
  std::vector<AxisKey> line_keys_;
  std::vector<std::string> line_names_;
  std::size_t per_line_ = 1;
  double left_ = 0, numbers_ = 0, gap_ = 0, panel_width_ = 0, panel_height_ = 0, title_height_ = 0,
         legend_ = 0;
  std::vector<std::string> fits_;
  bool has_zeros_ = false;
  bool shows_spread_ = false;
};

}  // namespace

FigureKind series_kind() {
  return {
      "series",
      "values against a number: one line a column key, one panel a row key and value",
      {{.name = "x", .meaning = "the axis or value that stands below", .default_value = ""},
       {.name = "logx", .meaning = "logarithmic axis below", .default_value = false},
       {.name = "logy", .meaning = "logarithmic upright axis", .default_value = true},
       {.name = "fit", .meaning = "powers of x fitted to the lines", .default_value = false},
       {.name = "x_label", .meaning = "text below; empty: the value's name", .default_value = ""},
       {.name = "y_label", .meaning = "text beside; empty: the value's name", .default_value = ""},
       {.name = "spread",
        .meaning = "how least and greatest of the samples show",
        .default_value = "bars",
        .choices = {"bars", "band", "none"}},
       {.name = "same_y", .meaning = "one upright scale for all panels of one value", .default_value = true},
       {.name = "panels_per_line",
        .meaning = "panels side by side; 0: 1 in a column, up to 3 on a page",
        .default_value = std::int64_t{0},
        .minimum = 0,
        .maximum = 12},
       width_option("column")},
      [](const FigureRequest& request) { return SeriesFigure(request).draw(); }};
}

}  // namespace gcslab
