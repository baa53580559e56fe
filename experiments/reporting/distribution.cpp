// Figure kind distribution: the share of jobs on which a value is at least a number, one line a column key,
// one panel a row key.

#include <algorithm>
#include <fmt/format.h>

#include "base/error.h"
#include "experiments/reporting/figure_registry.h"
#include "experiments/reporting/legend.h"
#include "experiments/reporting/measure.h"
#include "experiments/reporting/palette.h"
#include "experiments/reporting/plot_axis.h"

namespace gcslab {
namespace {

constexpr double kLeft = 13;  // upright label and numbers
constexpr double kGap = 5;
constexpr double kAxisHeight = 9;
constexpr double kTitleHeight = 5;
constexpr double kRightMargin = 3;

struct DistributionPanel {
  std::string title;
  std::vector<std::vector<double>> numbers;  ///< one list a line, sorted
};

class DistributionFigure {
 public:
  explicit DistributionFigure(const FigureRequest& request) : request_(request), value_(value_of(request)) {
    lines_ = request.item.columns.empty() ? std::vector<std::string>{"method"} : request.item.columns;
  }

  FigureScript draw() {
    figure_.width = width_from(request_.options);
    collect();
    lay_out();
    for (std::size_t i = 0; i < panels_.size(); ++i) draw_panel(i);
    figure_.notes.push_back(fmt::format("Share of {} jobs a line.", most_jobs()));
    for (std::string& note : notes_on_missing(request_.rows)) figure_.notes.push_back(std::move(note));
    return std::move(figure_);
  }

 private:
  static ValueName value_of(const FigureRequest& request) {
    if (request.item.values.size() != 1)
      throw InputError(request.item.where,
                       "'" + request.item.file + "': a distribution is that of one value");
    return ValueName(request.item.values.front());
  }

  static std::string joined(const std::vector<std::string>& axes, const AxisKey& key) {
    std::string text;
    for (std::size_t i = 0; i < key.size(); ++i) text += (i == 0 ? "" : ", ") + heading_of(axes[i], key[i]);
    return text;
  }

  void collect() {
    const std::vector<AxisKey> keys = keys_on(request_.rows, lines_);
    for (const AxisKey& key : keys) names_.push_back(joined(lines_, key));
    for (const AxisKey& panel_key : keys_on(request_.rows, request_.item.rows)) {
      const RowPointers rows = rows_at(request_.rows, request_.item.rows, panel_key);
      DistributionPanel panel{joined(request_.item.rows, panel_key), {}};
      for (const AxisKey& key : keys) panel.numbers.push_back(numbers_of(rows_at(rows, lines_, key)));
      panels_.push_back(std::move(panel));
    }
  }

  /// One a job that has a result.
  std::vector<double> numbers_of(const RowPointers& rows) const {
    std::vector<double> numbers;
    for (const Row* row : rows) {
      const std::optional<Measure> found = measure({row}, value_);
      if (found && found->is_number()) numbers.push_back(found->median);
    }
    std::ranges::sort(numbers);
    return numbers;
  }

  std::size_t most_jobs() const {
    std::size_t most = 0;
    for (const DistributionPanel& panel : panels_) {
      for (const std::vector<double>& numbers : panel.numbers) most = std::max(most, numbers.size());
    }
    return most;
  }

  void lay_out() {
    per_line_ = even_line(panels_.size(), figure_.width > kColumnWidth ? 2 : 1);
    const auto columns = static_cast<double>(per_line_);
    panel_width_ = (figure_.width - kLeft - kRightMargin - kGap * (columns - 1)) / columns;
    panel_height_ = std::min(panel_width_ * 0.6, 45.0);
    title_height_ = panels_.size() > 1 ? kTitleHeight : 1.5;
    legend_ = legend_height(names_, figure_.width);
    const std::size_t lines = (panels_.size() + per_line_ - 1) / per_line_;
    figure_.height =
        static_cast<double>(lines) * (title_height_ + panel_height_ + kAxisHeight) + legend_ + 0.5;
  }

  PanelBox box_of(std::size_t index) const {
    const auto column = static_cast<double>(index % per_line_);
    const auto line = static_cast<double>(index / per_line_);
    const double top = figure_.height - line * (title_height_ + panel_height_ + kAxisHeight) - title_height_;
    return {kLeft + column * (panel_width_ + kGap), top - panel_height_, panel_width_, panel_height_};
  }

  void draw_panel(std::size_t index) {
    const DistributionPanel& panel = panels_[index];
    const PanelBox box = box_of(index);
    const bool is_first = index % per_line_ == 0;
    figure_.command("\n# " + panel.title);
    if (panels_.size() > 1) figure_.text(box.left, box.top() + 2.2, panel.title, {"left", kTitleText});
    figure_.text(box.centre(), box.bottom - 6.3, "k: " + value_.heading(), {"center"});
    if (is_first)
      figure_.text(2, (box.bottom + box.top()) / 2, "jobs with k or more [%]",
                   {"center", kSmallText, palette::kText, true});
    if (index == 0) draw_legend(figure_, names_, kLeft, legend_);
    figure_.place(box);
    std::vector<double> all = {0};
    for (const std::vector<double>& numbers : panel.numbers)
      all.insert(all.end(), numbers.begin(), numbers.end());
    PlotAxis below = whole_number_axis(all);
    below.low = 0;
    figure_.command(below.commands('x'));
    PlotAxis shares = exact_axis(0, 100);
    shares.high = 103;  // a line at 100 % stands clear of the edge
    figure_.command(shares.commands('y', is_first));
    figure_.command(fmt::format("set grid ytics lt 1 lw 0.3 lc rgb '{}'", palette::kGrid));
    figure_.command("set border 3");
    figure_.command(plot_command(panel));
    figure_.clear_texts();
  }

  std::string plot_command(const DistributionPanel& panel) {
    std::string layers;
    for (std::size_t k = 0; k < panel.numbers.size(); ++k) {
      if (panel.numbers[k].empty()) continue;
      const std::size_t block = figure_.add_data(
          panel.title + ", " + names_[k] + "; k, % of jobs with k or more", data_lines(panel.numbers[k]));
      const LineLook look = line_look(k);
      layers += fmt::format(", \\\n  data index {} using 1:2 with fsteps {}", block, look.line_style(1.2));
      layers += fmt::format(", \\\n  data index {} using 1:2 with points pt {} ps 0.4 lc rgb '{}'", block,
                            look.point_type, look.colour);
    }
    return layers.empty() ? "plot NaN" : "plot " + layers.substr(2);
  }

  /// A point at every number that occurs.
  static std::string data_lines(const std::vector<double>& numbers) {
    std::string lines = numbers.front() > 0 ? "0 100\n" : "";
    const auto count = static_cast<double>(numbers.size());
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      if (i > 0 && numbers[i] == numbers[i - 1]) continue;
      const double share = 100 * static_cast<double>(numbers.size() - i) / count;
      lines += plot_number(numbers[i]) + " " + plot_number(share) + "\n";
    }
    return lines;
  }

  const FigureRequest& request_;
  ValueName value_;
  std::vector<std::string> lines_;  ///< axes
  std::vector<std::string> names_;
  std::vector<DistributionPanel> panels_;
  FigureScript figure_;
  std::size_t per_line_ = 1;
  double panel_width_ = 0, panel_height_ = 0, title_height_ = 0, legend_ = 0;
};

}  // namespace

FigureKind distribution_kind() {
  return {"distribution",
          "the share of jobs on which a value is at least a number: one line a column key, one panel a row "
          "key",
          {width_option("page")},
          [](const FigureRequest& request) { return DistributionFigure(request).draw(); }};
}

}  // namespace gcslab
