#include "experiments/reporting/path_drawing.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "experiments/reporting/legend.h"
#include "experiments/reporting/number_format.h"
#include "experiments/reporting/palette.h"
#include "experiments/reporting/plot_axis.h"

namespace gcslab {
namespace {

constexpr double kGap = 0.6;        // half of what is hidden behind a line, in millimetres
constexpr double kFinest = 0.03;    // between drawn points of a curve
constexpr double kSideMargin = 10;  // beside the box: numbers and names of axes
constexpr double kFootMargin = 9;
constexpr double kHeadMargin = 2;
constexpr double kFlatAspect = 0.75;
constexpr double kLegendLine = 3.6;

/// Colour and dashes of a curve: both differ from those of its neighbours in the list. Bold ones are solid.
std::string curve_style(const std::vector<PathCurve>& curves, std::size_t number) {
  constexpr std::size_t kDashes = 4;
  LineLook look = line_look(number);
  look.dash_type = curves[number].is_bold ? 1 : static_cast<int>(1 + number % kDashes);
  return look.line_style(curves[number].is_bold ? 3.2 : 1.1);
}

std::string line_of(double x, double y) { return plot_number(x) + " " + plot_number(y) + "\n"; }

class PathDrawing {
 public:
  PathDrawing(const PathPicture& picture, const PathStyle& style) : picture_(picture), style_(style) {
    script_.width = style.width;
    for (std::size_t k = 0; k < 3; ++k) axes_[k] = axis_of(k);
  }

  FigureScript draw() {
    style_.is_flat ? draw_flat() : draw_in_space();
    script_.notes.push_back(path_marks_text(picture_));
    return std::move(script_);
  }

 private:
  PlotAxis axis_of(std::size_t k) const {
    std::vector<double> numbers;
    if (k == 2) numbers = {0, 1};
    const auto add = [&](const std::vector<PathPoint>& points) {
      for (const PathPoint& point : points) numbers.push_back(point[k]);
    };
    for (const PathCurve& curve : picture_.curves) add(curve.points);
    for (const auto* points : {&picture_.sketches, &picture_.solutions, &picture_.critical}) add(*points);
    if (k < 2) return linear_axis(numbers, 4);
    const auto [low, high] = std::ranges::minmax(numbers);
    return exact_axis(low, high, 4);
  }

  void add_layer(const std::string& what, const std::string& lines, const std::string& with) {
    if (lines.empty()) return;
    const std::size_t block = script_.add_data(what, lines);
    layers_ +=
        fmt::format("{}data index {} using 1:2 with {}", layers_.empty() ? "" : ", \\\n  ", block, with);
  }

  template <class OnPaper>
  void add_marks(const OnPaper& on_paper) {
    const auto lines = [&](const std::vector<PathPoint>& points) {
      std::string text;
      for (const PathPoint& point : points) text += on_paper(point);
      return text;
    };
    add_layer("critical points, cleared", lines(picture_.critical), "points pt 7 ps 0.75 lc rgb 'white'");
    add_layer("critical points", lines(picture_.critical),
              fmt::format("points pt 6 ps 0.75 lw 1.2 lc rgb '{}'", palette::kVermillion));
    add_layer("sketch", lines(picture_.sketches),
              fmt::format("points pt 5 ps 0.6 lc rgb '{}'", palette::kText));
    add_layer("solutions", lines(picture_.solutions),
              fmt::format("points pt 7 ps 0.6 lc rgb '{}'", palette::kText));
  }

  /// A sample and a name for each of several curves.
  double legend_height() const {
    return picture_.curves.size() < 2 ? 0 : 1 + kLegendLine * static_cast<double>(picture_.curves.size());
  }
  void write_legend(double left, double top) {
    constexpr double kSample = 9;
    if (picture_.curves.size() < 2) return;
    for (std::size_t k = 0; k < picture_.curves.size(); ++k) {
      const double y = top - kLegendLine * (static_cast<double>(k) + 0.5);
      script_.rule(left, y, left + kSample, y, curve_style(picture_.curves, k));
      script_.text(left + kSample + 1.5, y, picture_.curves[k].name);
    }
  }

  // ---- one unknown against t ----

  void draw_flat() {
    const double legend = legend_height();
    const PanelBox panel = {13, 9 + legend, style_.width - 15, kFlatAspect * (style_.width - 15)};
    script_.height = panel.top() + 2;
    const std::vector<double> ends = {0, 1};
    for (const double t : ends)
      add_layer(fmt::format("t = {}", t), line_of(axes_[0].low, t) + line_of(axes_[0].high, t),
                "lines lw 0.6 lc rgb '#A0A0A0'");
    std::vector<std::string> lines;
    for (const PathCurve& curve : picture_.curves) {
      lines.emplace_back();
      for (const PathPoint& point : curve.points) lines.back() += line_of(point[0], point[2]);
    }
    add_curve_layers(lines);
    add_marks([](const PathPoint& point) { return line_of(point[0], point[2]); });
    script_.text(panel.centre(), panel.bottom - 6.3, picture_.unknowns[0], {"center"});
    script_.text(2, (panel.bottom + panel.top()) / 2, "t", {"center", kSmallText, palette::kText, true});
    write_legend(panel.left, legend);
    script_.place(panel);
    script_.command(axes_[0].commands('x'));
    script_.command(axes_[2].commands('y'));
    script_.command("set border 3; plot " + layers_);
    script_.clear_texts();
  }

  // ---- two unknowns and t ----

  /// The box is the unit cube.
  SeenPoint seen(const PathPoint& point) const {
    std::array<double, 3> part{};
    for (std::size_t k = 0; k < 3; ++k) part[k] = (point[k] - axes_[k].low) / (axes_[k].high - axes_[k].low);
    return style_.view.seen(part);
  }
  /// A corner of the box, by 0 or 1 on each axis.
  PathPoint corner(int x, int y, int t) const {
    return {x == 0 ? axes_[0].low : axes_[0].high, y == 0 ? axes_[1].low : axes_[1].high,
            t == 0 ? axes_[2].low : axes_[2].high};
  }
  PathPoint at_level(int x, int y, double t) const {
    PathPoint point = corner(x, y, 0);
    point[2] = t;
    return point;
  }

  std::string seen_lines(const std::vector<PathPoint>& points) const {
    std::string lines;
    for (const PathPoint& point : points) lines += line_of(seen(point).x, seen(point).y);
    return lines;
  }

  void draw_in_space() {
    const double legend = legend_height();
    place_box(legend);
    add_frame();
    add_curves();
    add_marks([this](const PathPoint& point) { return line_of(seen(point).x, seen(point).y); });
    add_axis_texts();
    write_legend(kSideMargin, legend);
    script_.place(panel_);
    script_.command(fmt::format("set xrange [{:.9g}:{:.9g}]; set yrange [{:.9g}:{:.9g}]", left_,
                                left_ + panel_.width / scale_, bottom_, bottom_ + panel_.height / scale_));
    script_.command("set border 0; unset xtics; unset ytics");
    script_.command("plot " + layers_);
    script_.clear_texts();
  }

  void place_box(double legend) {
    double right = -1e300, top = -1e300;
    left_ = bottom_ = 1e300;
    for (int k = 0; k < 8; ++k) {
      const SeenPoint p = seen(corner(k & 1, (k >> 1) & 1, k >> 2));
      left_ = std::min(left_, p.x);
      right = std::max(right, p.x);
      bottom_ = std::min(bottom_, p.y);
      top = std::max(top, p.y);
    }
    scale_ = (style_.width - 2 * kSideMargin) / (right - left_);
    panel_ = {kSideMargin, kFootMargin + legend, style_.width - 2 * kSideMargin, (top - bottom_) * scale_};
    script_.height = panel_.top() + kHeadMargin;
  }

  /// The planes t = 0 and t = 1, and the edges of the box; the front ones, which the curves pass behind, are
  /// dotted.
  void add_frame() {
    for (const auto& [t, colour] : {std::pair{0.0, palette::kBlack}, std::pair{1.0, palette::kOrange}}) {
      const std::string lines = seen_lines(
          {at_level(0, 0, t), at_level(1, 0, t), at_level(1, 1, t), at_level(0, 1, t), at_level(0, 0, t)});
      add_layer(fmt::format("plane t = {}", t), lines,
                fmt::format("filledcurves closed fs transparent solid 0.07 noborder lc rgb '{}'", colour));
      add_layer(fmt::format("border of the plane t = {}", t), lines, "lines lw 0.5 lc rgb '#A0A0A0'");
    }
    std::string rear, front;
    for (const auto& [x, y] : {std::pair{1, 0}, {1, 1}, {0, 1}})
      rear += (rear.empty() ? "" : "\n") + seen_lines({corner(x, y, 0), corner(x, y, 1)});
    for (const int t : {0, 1}) rear += "\n" + seen_lines({corner(1, 0, t), corner(1, 1, t), corner(0, 1, t)});
    rear += "\n" + seen_lines({corner(1, 0, 0), corner(0, 0, 0), corner(0, 1, 0)});
    front = seen_lines({corner(0, 0, 0), corner(0, 0, 1)}) + "\n" +
            seen_lines({corner(1, 0, 1), corner(0, 0, 1), corner(0, 1, 1)});
    add_layer("edges of the box", rear, fmt::format("lines lw 0.5 lc rgb '{}'", palette::kFrame));
    add_layer("front edges of the box", front, fmt::format("lines lw 0.5 dt 3 lc rgb '{}'", palette::kFrame));
  }

  /// Without points that paper cannot tell apart.
  std::vector<SeenPoint> thinned(const std::vector<PathPoint>& points) const {
    std::vector<SeenPoint> result;
    for (const PathPoint& point : points) {
      const SeenPoint p = seen(point);
      if (result.empty() || std::hypot(p.x - result.back().x, p.y - result.back().y) * scale_ >= kFinest)
        result.push_back(p);
    }
    return result;
  }

  void add_curves() {
    std::vector<std::vector<SeenPoint>> curves;
    std::vector<std::string> lines(picture_.curves.size());
    for (std::size_t k = 0; k < lines.size(); ++k) {
      const PathCurve& curve = picture_.curves[k];
      curves.push_back(curve.is_bold ? std::vector<SeenPoint>{} : thinned(curve.points));
      if (curve.is_bold) lines[k] = seen_lines(curve.points);
    }
    for (const VisiblePart& part : visible_parts(curves, kGap / scale_)) {
      std::string& text = lines[part.line];
      if (!text.empty()) text += "\n";
      for (const SeenPoint& p : part.points) text += line_of(p.x, p.y);
    }
    add_curve_layers(lines);
  }

  void add_curve_layers(const std::vector<std::string>& lines) {
    for (const bool is_bold : {true, false}) {
      for (std::size_t k = 0; k < lines.size(); ++k) {
        if (picture_.curves[k].is_bold == is_bold)
          add_layer(picture_.curves[k].name, lines[k], "lines " + curve_style(picture_.curves, k));
      }
    }
  }

  std::array<double, 2> on_paper(const PathPoint& point) const {
    const SeenPoint p = seen(point);
    return {panel_.left + (p.x - left_) * scale_, panel_.bottom + (p.y - bottom_) * scale_};
  }

  /// Numbers along the two lower front edges and the left upright one, and the names of the axes beside them.
  void add_axis_texts() {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto place = [&](double value) {
        PathPoint point = k == 2 ? corner(0, 1, 0) : corner(0, 0, 0);
        point[k] = value;
        return on_paper(point);
      };
      const std::string_view alignment = k == 1 || k == 2 ? "right" : "left";
      const double right = k == 0 ? 1.0 : k == 1 ? -1.0 : -1.4, down = k == 2 ? 0 : 1.6;
      for (const auto& [value, words] : axes_[k].tics) {
        if (k == 1 && value == axes_[k].high) continue;  // there the numbers of t begin
        const auto [x, y] = place(value);
        script_.rule(x, y, x + 0.6 * right, y - 0.6 * down, "lw 0.5 lc rgb '#505050'");
        script_.text(x + right, y - down, with_minus_sign(words), {alignment});
      }
      const auto [x, y] = place((axes_[k].low + axes_[k].high) / 2);
      const std::string name = k == 2 ? "t" : picture_.unknowns[k];
      script_.text(x + 5 * right, y - 3.6 * down, name, {alignment, kTitleText});
    }
  }

  const PathPicture& picture_;
  const PathStyle& style_;
  FigureScript script_;
  std::array<PlotAxis, 3> axes_;
  std::string layers_;
  PanelBox panel_;
  double left_ = 0, bottom_ = 0, scale_ = 1;  ///< of the box on paper
};

}  // namespace

FigureScript draw_paths(const PathPicture& picture, const PathStyle& style) {
  return PathDrawing(picture, style).draw();
}

std::string path_marks_text(const PathPicture& picture) {
  std::string text = "Grey: t = 0 and t = 1.";
  if (!picture.sketches.empty()) text += " Squares: sketches.";
  if (!picture.solutions.empty()) text += " Discs: solutions.";
  if (!picture.critical.empty()) text += " Rings: critical points.";
  return text;
}

}  // namespace gcslab
