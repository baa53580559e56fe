// Figure kind range_bars: the graph of a function over its box, and the range that each method finds for it.

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "experiments/reporting/figure_registry.h"
#include "experiments/reporting/measure.h"
#include "experiments/reporting/number_format.h"
#include "experiments/reporting/palette.h"
#include "experiments/reporting/plot_axis.h"

namespace gcslab {
namespace {

constexpr double kBarPitch = 5;
constexpr double kTitleHeight = 6.5;
constexpr double kAxisHeight = 8.5;
constexpr double kGraphLeft = 10;
constexpr double kSmallestHeight = 34;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// One line of the figure: a function and its bounds.
struct Subject {
  std::string title;
  RowPointers rows;          ///< one a method
  std::vector<Point> graph;  ///< empty: no graph is known, as for functions of several variables
  double lower = kNone;      ///< exact range, where known
  double upper = kNone;
  double height = 0;
};

class RangeBars {
 public:
  explicit RangeBars(const FigureRequest& request) : request_(request), item_(request.item) {}

  FigureScript draw() {
    figure_.width = width_from(request_.options);
    collect();
    double top = figure_.height;
    for (const Subject& subject : subjects_) {
      draw_subject(subject, top);
      top -= total_height(subject);
    }
    write_notes();
    return std::move(figure_);
  }

 private:
  // ---- what is shown ----

  void collect() {
    std::vector<std::string> axes = item_.rows.empty() ? std::vector<std::string>{"problem"} : item_.rows;
    for (const AxisKey& key : keys_on(request_.rows, axes)) {
      Subject subject = subject_of(rows_at(request_.rows, axes, key));
      for (std::size_t i = 0; i < key.size(); ++i)
        subject.title += (i == 0 ? "" : ", ") + heading_of(axes[i], key[i]);
      figure_.height += total_height(subject);
      subjects_.push_back(std::move(subject));
    }
  }

  static double number(const Row& row, const char* name) {
    const std::vector<double> samples = samples_of(row, ValueName(name));
    return samples.empty() ? kNone : samples.front();
  }

  Subject subject_of(const RowPointers& rows) const {
    check_groups(rows, {"problem", "method"}, item_);
    Subject subject;
    subject.rows = rows;
    subject.height = std::max(kSmallestHeight, kBarPitch * static_cast<double>(rows.size()) + 2);
    for (const Row* row : rows) {
      if (!row->has_result()) continue;
      if (std::isnan(subject.lower)) subject.lower = number(*row, "exact_lower");
      if (std::isnan(subject.upper)) subject.upper = number(*row, "exact_upper");
      if (subject.graph.empty()) subject.graph = graph_of(*row);
    }
    return subject;
  }

  static std::vector<Point> graph_of(const Row& row) {
    std::vector<Point> points;
    if (!row.artifact.is_object() || !row.artifact.contains("graph")) return points;
    for (const Json& sample : row.artifact.at("graph")) {
      points.push_back({sample.at(0).get<double>(), sample.at(1).get<double>()});
    }
    return points;
  }

  // ---- drawing ----

  /// In a column the graph stands above the bars, on a page beside them.
  bool is_stacked() const { return figure_.width <= kColumnWidth; }

  double graph_height(const Subject& subject) const {
    return is_stacked() ? kSmallestHeight : subject.height;
  }

  double total_height(const Subject& subject) const {
    const double bars = kTitleHeight + subject.height + kAxisHeight;
    return is_stacked() && !subject.graph.empty() ? bars + graph_height(subject) + kAxisHeight : bars;
  }

  void draw_subject(const Subject& subject, double top) {
    figure_.command("\n# " + subject.title);
    figure_.text(2, top - 2.5, subject.title, {"left", kTitleText});
    top -= kTitleHeight;
    double left = 2;
    if (!subject.graph.empty()) {
      const double width =
          is_stacked() ? figure_.width - kGraphLeft - 3 : std::min(0.3 * figure_.width, 48.0);
      draw_graph(subject, {kGraphLeft, top - graph_height(subject), width, graph_height(subject)});
      if (is_stacked()) top -= graph_height(subject) + kAxisHeight;
      if (!is_stacked()) left = kGraphLeft + width + 4;
    }
    left += widest_label(subject) + 1;
    const double width = figure_.width - left - widest_bound(subject) - 2;
    draw_bars(subject, {left, top - subject.height, width, subject.height});
  }

  std::string band_rectangle(const Subject& subject, bool upright) const {
    const auto at = [&](double range, const char* edge) {
      return upright ? fmt::format("{},graph {}", plot_number(range), edge)
                     : fmt::format("graph {},first {}", edge, plot_number(range));
    };
    return fmt::format("set object 1 rectangle from {} to {} behind fs solid 1 noborder fc rgb '{}'",
                       at(subject.lower, "0"), at(subject.upper, "1"), palette::kBand);
  }

  void draw_graph(const Subject& subject, const PanelBox& box) {
    std::string lines;
    std::vector<double> heights = {subject.lower, subject.upper};
    for (const Point& p : subject.graph) {
      lines += plot_number(p[0]) + " " + plot_number(p[1]) + "\n";
      heights.push_back(p[1]);
    }
    const std::size_t block = figure_.add_data(subject.title + ", graph", lines);
    figure_.text(box.centre(), box.bottom - 6.3, "x", {"center"});
    figure_.place(box);
    figure_.command(exact_axis(subject.graph.front()[0], subject.graph.back()[0], 4).commands('x'));
    figure_.command(linear_axis(heights, 4).commands('y'));
    if (!std::isnan(subject.lower)) figure_.command(band_rectangle(subject, false));
    figure_.command("set border 3");
    figure_.command(
        fmt::format("plot data index {} using 1:2 with lines lw 1.2 lc rgb '{}'", block, palette::kBlack));
    figure_.command("unset object");
    figure_.clear_texts();
  }

  static std::string bound_text(const Row& row) {
    if (!row.has_result()) return outcome_word(row);
    return "[" + end_text(row, "lower") + ", " + end_text(row, "upper") + "]";
  }

  static std::string end_text(const Row& row, const char* name) {
    const double end = number(row, name);
    return std::isnan(end) ? "?" : with_minus_sign(fmt::format("{:.4g}", end));
  }

  double widest_label(const Subject& subject) const {
    double widest = 0;
    for (const Row* row : subject.rows) widest = std::max(widest, text_width(row->at("method")));
    return widest;
  }

  double widest_bound(const Subject& subject) const {
    double widest = 0;
    for (const Row* row : subject.rows) widest = std::max(widest, text_width(bound_text(*row)));
    return widest;
  }

  void draw_bars(const Subject& subject, const PanelBox& box) {
    std::vector<double> ends = {subject.lower, subject.upper};
    std::string lines;
    const auto count = static_cast<double>(subject.rows.size());
    for (std::size_t i = 0; i < subject.rows.size(); ++i) {
      const Row& row = *subject.rows[i];
      const double place = count - static_cast<double>(i);
      const double y = box.bottom + box.height * (place - 0.5) / count;
      figure_.text(box.left - 1.5, y, row.at("method"), {"right"});
      figure_.text(box.right() + 1.5, y, bound_text(row),
                   {"left", kSmallText, row.has_result() ? palette::kText : palette::kQuietText});
      if (!row.has_result()) continue;
      const double lower = number(row, "lower");
      const double upper = number(row, "upper");
      ends.push_back(lower);
      ends.push_back(upper);
      lines +=
          fmt::format("{} {} {} # {}\n", plot_number(lower), plot_number(upper), place, row.at("method"));
    }
    figure_.text(box.centre(), box.bottom - 6.3, request_.options.word("x_label"), {"center"});
    figure_.place(box);
    figure_.command(linear_axis(ends).commands('x'));
    figure_.command(fmt::format("set yrange [0.5:{}]; set ytics ('' -1); unset logscale y", count + 0.5));
    if (!std::isnan(subject.lower)) figure_.command(band_rectangle(subject, true));
    figure_.command("set border 1");
    figure_.command(lines.empty()
                        ? "plot NaN"
                        : bar_command(figure_.add_data(subject.title + ", lower, upper, place", lines)));
    figure_.command("unset object");
    figure_.clear_texts();
  }

  /// Thick bars without ends; a bound that is one point still shows.
  static std::string bar_command(std::size_t block) {
    return fmt::format(
        "plot data index {} using 1:3:1:2:($3-0.22):($3+0.22) with boxxyerror fc rgb '{}' fs solid 1 border "
        "lc rgb '{}' lw 0.6",
        block, palette::kSky, palette::kBlue);
  }

  void write_notes() {
    const bool has_exact =
        std::ranges::any_of(subjects_, [](const Subject& s) { return !std::isnan(s.lower); });
    if (has_exact) figure_.notes.emplace_back("Shaded: the exact range.");
    for (std::string& note : notes_on_missing(request_.rows)) figure_.notes.push_back(std::move(note));
  }

  const FigureRequest& request_;
  const ReportItem& item_;
  FigureScript figure_;
  std::vector<Subject> subjects_;
};

}  // namespace

FigureKind range_bars_kind() {
  return {"range_bars",
          "the graph of a function over its box, and the range that each method finds for it",
          {{.name = "x_label", .meaning = "text below the bars", .default_value = "range of f"},
           width_option("page")},
          [](const FigureRequest& request) { return RangeBars(request).draw(); }};
}

}  // namespace gcslab
