// Figure kind performance_profile: for every factor, the share of problems that a method solves within that
// factor of the best method (Dolan, More 2002), one panel a value.

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "base/error.h"
#include "experiments/reporting/figure_registry.h"
#include "experiments/reporting/legend.h"
#include "experiments/reporting/number_format.h"
#include "experiments/reporting/palette.h"
#include "experiments/reporting/plot_axis.h"
#include "experiments/reporting/solver_comparison.h"

namespace gcslab {
namespace {

constexpr double kLeft = 13;       // upright label and numbers
constexpr double kGap = 5;         // between panels
constexpr double kAxisHeight = 9;  // numbers and label below a panel
constexpr double kTitleHeight = 5;
constexpr double kRightMargin = 3;

struct ProfilePanel {
  ValueName value;
  std::vector<PerformanceProfile> profiles;  ///< one a method
};

class ProfileFigure {
 public:
  explicit ProfileFigure(const FigureRequest& request)
      : request_(request), comparison_(request.rows), solved_(solved_from(request.options)) {}

  FigureScript draw() {
    figure_.width = width_from(request_.options);
    collect();
    lay_out();
    for (std::size_t i = 0; i < panels_.size(); ++i) draw_panel(i);
    write_notes();
    return std::move(figure_);
  }

 private:
  // ---- profiles ----

  void collect() {
    for (std::size_t problem = 0; problem < comparison_.problems(); ++problem) {
      if (comparison_.is_complete(problem)) shared_.push_back(problem);
    }
    if (shared_.empty())
      throw InputError(request_.item.where,
                       "'" + request_.item.file + "': no problem has a run of every method");
    std::vector<std::string> values = request_.item.values;
    if (values.empty()) values = {"cpu_s"};
    for (const std::string& name : values) {
      const ValueName value(name);
      panels_.push_back({value, performance_profiles(costs(value), floor_of(value))});
    }
  }

  std::vector<std::vector<std::optional<double>>> costs(const ValueName& value) const {
    std::vector<std::vector<std::optional<double>>> all;
    for (const std::size_t problem : shared_) {
      auto& of_problem = all.emplace_back();
      for (std::size_t method = 0; method < comparison_.methods().size(); ++method)
        of_problem.push_back(comparison_.cost(problem, method, value, solved_));
    }
    return all;
  }

  /// Shorter times are not told apart, and neither are counts below 1.
  double floor_of(const ValueName& value) const {
    return value.unit() == "s" ? request_.options.real("shortest_time") : 1;
  }

  double largest_ratio(const ProfilePanel& panel) const {
    const double wanted = request_.options.real("largest_ratio");
    if (wanted > 0) return wanted;
    double largest = 2;
    for (const PerformanceProfile& profile : panel.profiles) {
      if (!profile.ratios.empty()) largest = std::max(largest, profile.ratios.back());
    }
    return largest * 1.2;
  }

  // ---- layout ----

  void lay_out() {
    const std::size_t most = figure_.width > kColumnWidth ? 2 : 1;
    per_line_ = even_line(panels_.size(), most);
    const auto columns = static_cast<double>(per_line_);
    panel_width_ = (figure_.width - kLeft - kRightMargin - kGap * (columns - 1)) / columns;
    panel_height_ = std::min(panel_width_ * 0.72, 62.0);
    title_height_ = panels_.size() > 1 ? kTitleHeight : 1.5;
    legend_ = legend_height(comparison_.methods(), figure_.width);
    const std::size_t lines = (panels_.size() + per_line_ - 1) / per_line_;
    figure_.height =
        static_cast<double>(lines) * (title_height_ + panel_height_ + kAxisHeight) + legend_ + 0.5;
  }

  PanelBox box_of(std::size_t index) const {
    const auto column = static_cast<double>(index % per_line_);
    const std::size_t line = index / per_line_;
    const double top = figure_.height -
                       static_cast<double>(line) * (title_height_ + panel_height_ + kAxisHeight) -
                       title_height_;
    return {kLeft + column * (panel_width_ + kGap), top - panel_height_, panel_width_, panel_height_};
  }

  /// From exactly 1: to the left of it there is nothing. A short axis needs more tics than powers of ten.
  PlotAxis ratio_axis(const ProfilePanel& panel) const {
    constexpr double kShort = 200;
    const double edge = largest_ratio(panel);
    PlotAxis axis = logarithmic_axis({1, edge});
    axis.low = 1;
    axis.high = edge;
    if (edge <= kShort)
      axis.tics = {{1, "1"}, {2, "2"}, {5, "5"}, {10, "10"}, {20, "20"}, {50, "50"}, {100, "100"}};
    std::erase_if(axis.tics, [&](const auto& tic) { return tic.first < 1 || tic.first > edge; });
    return axis;
  }

  // ---- drawing ----

  void draw_panel(std::size_t index) {
    const ProfilePanel& panel = panels_[index];
    const PanelBox box = box_of(index);
    const bool is_first = index % per_line_ == 0;
    figure_.command("\n# " + panel.value.heading());
    if (panels_.size() > 1)
      figure_.text(box.left, box.top() + 2.2, panel.value.heading(), {"left", kTitleText});
    figure_.text(box.centre(), box.bottom - 6.3,
                 "τ: " + panel.value.heading() + " over the least of the methods", {"center"});
    if (is_first)
      figure_.text(2, (box.bottom + box.top()) / 2, "problems solved within τ [%]",
                   {"center", kSmallText, "#202020", true});
    if (index == 0) draw_legend(figure_, comparison_.methods(), kLeft, legend_);
    figure_.place(box);
    figure_.command(ratio_axis(panel).commands('x'));
    PlotAxis shares = exact_axis(0, 100);
    shares.high = 102;  // a line at 100 % stands clear of the edge
    figure_.command(shares.commands('y', is_first));
    figure_.command(fmt::format("set grid ytics lt 1 lw 0.3 lc rgb '{}'", palette::kGrid));
    figure_.command("set border 3");
    figure_.command(plot_command(panel));
    figure_.clear_texts();
  }

  std::string plot_command(const ProfilePanel& panel) {
    std::string lines;
    for (std::size_t method = 0; method < panel.profiles.size(); ++method) {
      const std::string& name = comparison_.methods()[method];
      const std::size_t block =
          figure_.add_data(panel.value.heading() + ", " + name + "; ratio, % of problems",
                           data_lines(panel.profiles[method], largest_ratio(panel)));
      const LineLook look = line_look(method);
      lines += fmt::format(", \\\n  data index {} using 1:2 with steps {}", block, look.line_style(1.4));
      lines += fmt::format(", \\\n  data index {} using 1:2 every {} with points pt {} ps 0.45 lc rgb '{}'",
                           block, stride(panel.profiles[method]), look.point_type, look.colour);
    }
    return "plot " + lines.substr(2);
  }

  /// About eight markers on each line.
  static std::size_t stride(const PerformanceProfile& profile) {
    return std::max<std::size_t>(1, profile.ratios.size() / 8);
  }

  /// A step at every ratio, and the line on to the right edge.
  static std::string data_lines(const PerformanceProfile& profile, double edge) {
    std::string lines;
    double share = 100 * profile.share(1);
    lines += fmt::format("1 {}\n", plot_number(share));
    for (const double ratio : profile.ratios) {
      if (ratio <= 1 || ratio > edge) continue;
      share = 100 * profile.share(ratio);
      lines += fmt::format("{} {}\n", plot_number(ratio), plot_number(share));
    }
    return lines + fmt::format("{} {}\n", plot_number(edge), plot_number(share));
  }

  // ---- what the reader must know ----

  void write_notes() {
    figure_.notes.push_back(
        fmt::format("Share of {} problems; a line ends at the share that the method solves{}.",
                    shared_.size(), criterion_text()));
    note_unsolved();
    if (shared_.size() < comparison_.problems())
      figure_.notes.push_back(
          fmt::format("{} problems are left out, for which not every method has a figure.",
                      comparison_.problems() - shared_.size()));
    const bool timed =
        std::ranges::any_of(panels_, [](const ProfilePanel& p) { return p.value.unit() == "s"; });
    if (!timed) return;
    figure_.notes.push_back("Times below " +
                            format_significant(request_.options.real("shortest_time") * 1e3, 2) +
                            " ms count as that.");
    const std::string machine = machine_text(request_.context.rows);
    if (!machine.empty()) figure_.notes.push_back("Measured on one machine (" + machine + ").");
  }

  std::string criterion_text() const {
    return solved_ == Solved::proved ? " with proof of completeness"
                                     : " with nothing undecided and all known solutions found";
  }

  void note_unsolved() {
    std::string names;
    std::size_t count = 0;
    for (const std::size_t problem : shared_) {
      bool any = false;
      for (std::size_t m = 0; m < comparison_.methods().size(); ++m)
        any = any || comparison_.is_solved(problem, m, solved_);
      if (any) continue;
      ++count;
      names += (names.empty() ? "" : ", ") + heading_of("problem", comparison_.problem_name(problem));
    }
    if (count > 0) figure_.notes.push_back(fmt::format("No method solves {} of them ({}).", count, names));
  }

  const FigureRequest& request_;
  SolverComparison comparison_;
  Solved solved_;
  FigureScript figure_;
  std::vector<std::size_t> shared_;  ///< problems for which every method has a run
  std::vector<ProfilePanel> panels_;
  std::size_t per_line_ = 1;
  double panel_width_ = 0, panel_height_ = 0, title_height_ = 0, legend_ = 0;
};

}  // namespace

FigureKind performance_profile_kind() {
  return {"performance_profile",
          "share of problems that each method solves within a factor of the best one, one panel a value",
          {solved_option(),
           real_option("shortest_time", "shorter times are not told apart", "s", 0.001, 1e-9, 1e3),
           real_option("largest_ratio", "the right edge; 0: the largest that occurs", "", 0, 0, 1e12),
           width_option("column")},
          [](const FigureRequest& request) { return ProfileFigure(request).draw(); }};
}

}  // namespace gcslab
