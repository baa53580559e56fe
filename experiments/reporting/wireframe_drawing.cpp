#include "experiments/reporting/wireframe_drawing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

#include "experiments/reporting/label_placement.h"
#include "experiments/reporting/number_format.h"
#include "experiments/reporting/palette.h"

namespace gcslab {
namespace {

constexpr double kGap = 0.6;  // half of what is hidden behind a perpendicular edge, in millimetres

/// How edges look, from the farthest to the nearest.
struct Shade {
  std::string_view colour;
  double line_width;
};
constexpr std::array kShades = {Shade{"#B9C3CC", 0.55}, Shade{"#9AA8B5", 0.7}, Shade{"#7A8C9C", 0.85},
                                Shade{"#5A7083", 1.0},  Shade{"#38536B", 1.2}, Shade{"#143653", 1.4}};

std::string point_line(double x, double y) { return plot_number(x) + " " + plot_number(y) + "\n"; }

class WirePanel {
 public:
  WirePanel(FigureScript& script, const PanelBox& panel, const Wireframe& figure, const WireLook& look,
            double scale, const std::string& name)
      : script_(script),
        panel_(panel),
        figure_(figure),
        look_(look),
        scale_(scale),
        name_(name),
        points_(seen_points(look.view, figure.points)),
        bounds_(seen_bounds(figure, look.view)) {
    const auto [near, far] = std::ranges::minmax(points_, {}, &SeenPoint::away);
    nearest_ = near.away;
    farthest_ = far.away;
  }

  void draw() {
    add_faces();
    add_edges();
    add_arcs();
    add_points();
    add_labels();
    script_.place(panel_);
    const double x = (bounds_.left + bounds_.right) / 2, y = (bounds_.bottom + bounds_.top) / 2;
    const double across = panel_.width / scale_ / 2, up = panel_.height / scale_ / 2;
    script_.command(fmt::format("set xrange [{:.9g}:{:.9g}]; set yrange [{:.9g}:{:.9g}]", x - across,
                                x + across, y - up, y + up));
    script_.command("set border 0; unset xtics; unset ytics");
    script_.command(layers_.empty() ? "plot NaN" : "plot " + layers_);
  }

 private:
  bool is_plane() const { return figure_.points.empty() || figure_.points.front().size() == 2; }

  bool shows_values() const { return look_.values && (is_plane() || look_.dimensions); }

  /// Small figures have finer lines and points.
  double weight() const {
    constexpr double kFull = 25;  // millimetres
    return std::clamp(scale_ * std::max(bounds_.width(), bounds_.height()) / kFull, 0.6, 1.0);
  }

  /// On paper, in millimetres.
  PaperPoint on_paper(const SeenPoint& p) const {
    return {panel_.centre() + (p.x - (bounds_.left + bounds_.right) / 2) * scale_,
            (panel_.bottom + panel_.top()) / 2 + (p.y - (bounds_.bottom + bounds_.top) / 2) * scale_};
  }

  void add_layer(const std::string& what, const std::string& lines, const std::string& with) {
    if (lines.empty()) return;
    const std::size_t block = script_.add_data(name_ + ", " + what, lines);
    layers_ +=
        fmt::format("{}data index {} using 1:2 with {}", layers_.empty() ? "" : ", \\\n  ", block, with);
  }

  void add_faces() {
    std::string lines;
    for (const std::vector<std::size_t>& face : figure_.faces) {
      if (!lines.empty()) lines += "\n";
      for (const std::size_t p : face) lines += point_line(points_[p].x, points_[p].y);
      lines += point_line(points_[face.front()].x, points_[face.front()].y);
    }
    add_layer(
        "faces", lines,
        fmt::format("filledcurves closed fs transparent solid 0.13 noborder lc rgb '{}'", palette::kSky));
  }

  /// Number of the shade for a depth; real, so that edges can be cut where it becomes whole.
  double shade_at(double away) const {
    const double range = farthest_ - nearest_;
    const double size = std::max(bounds_.width(), bounds_.height());
    const double nearness = range > 1e-6 * size ? (farthest_ - away) / range : 1;
    return nearness * static_cast<double>(kShades.size());
  }

  static std::size_t shade_number(double shade) {
    return static_cast<std::size_t>(std::clamp(shade, 0.0, static_cast<double>(kShades.size()) - 0.5));
  }

  /// Cuts a line where its shade changes.
  void shade(const SeenPoint& from, const SeenPoint& to,
             std::array<std::string, kShades.size()>& lines) const {
    const double first = shade_at(from.away), last = shade_at(to.away);
    std::vector<double> cuts = {0, 1};
    for (std::size_t k = 1; k < kShades.size(); ++k) {
      const double t = (static_cast<double>(k) - first) / (last - first);
      if (t > 0 && t < 1) cuts.push_back(t);
    }
    std::ranges::sort(cuts);
    const double dx = to.x - from.x, dy = to.y - from.y;
    for (std::size_t i = 1; i < cuts.size(); ++i) {
      const double middle = (cuts[i - 1] + cuts[i]) / 2;
      std::string& target = lines[shade_number(first + middle * (last - first))];
      if (!target.empty()) target += "\n";
      target += point_line(from.x + cuts[i - 1] * dx, from.y + cuts[i - 1] * dy) +
                point_line(from.x + cuts[i] * dx, from.y + cuts[i] * dy);
    }
  }

  void add_edges() {
    std::array<std::string, kShades.size()> lines;
    std::string guides;
    std::vector<std::vector<SeenPoint>> straight;
    for (const WireEdge& edge : figure_.edges) straight.push_back({points_[edge.from], points_[edge.to]});
    for (const VisiblePart& part : visible_parts(straight, weight() * kGap / scale_)) {
      const SeenPoint &from = part.points.front(), &to = part.points.back();
      if (figure_.edges[part.line].is_guide) {
        guides += (guides.empty() ? "" : "\n") + point_line(from.x, from.y) + point_line(to.x, to.y);
      } else {
        shade(from, to, lines);
      }
    }
    add_layer("pairs of points without a length", guides, "lines lw 0.5 dt 2 lc rgb '#808080'");
    for (std::size_t k = 0; k < kShades.size(); ++k) {
      add_layer(
          fmt::format("edges, depth {} of {} from the rear", k + 1, kShades.size()), lines[k],
          fmt::format("lines lw {:.3g} lc rgb '{}'", weight() * kShades[k].line_width, kShades[k].colour));
    }
  }

  void add_points() {
    std::array<std::string, kShades.size()> lines;
    for (const SeenPoint& p : points_) lines[shade_number(shade_at(p.away))] += point_line(p.x, p.y);
    for (std::size_t k = 0; k < kShades.size(); ++k) {
      add_layer(fmt::format("points, depth {} from the rear", k + 1), lines[k],
                fmt::format("points pt 7 ps {:.3g} lc rgb '{}'", 0.42 * weight(), kShades[k].colour));
    }
  }

  // ---- angles, in the plane ----

  /// The arc of an angle on paper, from its first arm to its second the short way.
  std::vector<PaperPoint> arc(const WireAngle& angle) const {
    constexpr double kRadius = 4.5;
    constexpr int kParts = 24;
    const PaperPoint at = on_paper(points_[angle.at]);
    const auto direction = [&](std::size_t end) {
      const PaperPoint p = on_paper(points_[end]);
      return std::array{std::atan2(p[1] - at[1], p[0] - at[0]), std::hypot(p[0] - at[0], p[1] - at[1])};
    };
    const auto [first, one_arm] = direction(angle.from);
    const auto [second, other_arm] = direction(angle.to);
    const double turn = std::remainder(second - first, 2 * std::numbers::pi);
    const double radius = std::min({kRadius, one_arm / 2, other_arm / 2});
    std::vector<PaperPoint> result;
    for (int k = 0; k <= kParts; ++k) {
      const double direction_now = first + turn * k / kParts;
      result.push_back({at[0] + radius * std::cos(direction_now), at[1] + radius * std::sin(direction_now)});
    }
    return result;
  }

  void add_arcs() {
    if (!shows_values()) return;
    std::string lines;
    for (const WireAngle& angle : figure_.angles) {
      if (!lines.empty()) lines += "\n";
      for (const PaperPoint& p : arc(angle)) {
        lines += point_line(
            (p[0] - panel_.centre()) / scale_ + (bounds_.left + bounds_.right) / 2,
            (p[1] - (panel_.bottom + panel_.top()) / 2) / scale_ + (bounds_.bottom + bounds_.top) / 2);
      }
    }
    add_layer("angles", lines, fmt::format("lines lw 0.6 lc rgb '{}'", palette::kVermillion));
  }

  // ---- texts ----

  PaperSegment segment(const WireEdge& edge) const {
    return {on_paper(points_[edge.from]), on_paper(points_[edge.to])};
  }

  LabelPlacer placer() const {
    std::vector<PaperSegment> lines;
    std::vector<PaperPoint> points;
    for (const WireEdge& edge : figure_.edges) lines.push_back(segment(edge));
    for (const SeenPoint& p : points_) points.push_back(on_paper(p));
    if (shows_values()) {
      for (const WireAngle& angle : figure_.angles) {
        const std::vector<PaperPoint> curve = arc(angle);
        for (std::size_t i = 1; i < curve.size(); ++i) lines.push_back({curve[i - 1], curve[i]});
      }
    }
    return {{{panel_.centre(), (panel_.bottom + panel_.top()) / 2}, panel_.width, panel_.height},
            std::move(lines),
            std::move(points)};
  }

  /// From the neighbours of a point outwards.
  PaperPoint away_from_neighbours(std::size_t point) const {
    const PaperPoint at = on_paper(points_[point]);
    PaperPoint sum = {0, 0};
    for (const WireEdge& edge : figure_.edges) {
      if (edge.from != point && edge.to != point) continue;
      const PaperPoint other = on_paper(points_[edge.from == point ? edge.to : edge.from]);
      const double length = std::hypot(at[0] - other[0], at[1] - other[1]);
      if (length == 0) continue;
      for (std::size_t axis = 0; axis < 2; ++axis) sum[axis] += (at[axis] - other[axis]) / length;
    }
    return sum;
  }

  void write(const PaperPoint& place, const std::string& words, std::string_view colour) {
    script_.text(place[0], place[1], words, {"center", kSmallText, colour});
  }

  void add_labels() {
    LabelPlacer labels = placer();
    if (look_.names) {
      for (std::size_t p = 0; p < points_.size(); ++p)
        write(labels.beside_point(on_paper(points_[p]), away_from_neighbours(p), figure_.names[p]),
              figure_.names[p], palette::kText);
    }
    if (!shows_values()) return;
    for (const WireAngle& angle : figure_.angles) {
      const std::vector<PaperPoint> curve = arc(angle);
      const PaperPoint middle = curve[curve.size() / 2], at = on_paper(points_[angle.at]);
      const std::string words = with_minus_sign(angle.label);
      write(labels.beyond_point(middle, {middle[0] - at[0], middle[1] - at[1]}, words), words,
            palette::kVermillion);
    }
    for (const WireEdge& edge : edges_by_length()) {
      if (edge.label.empty()) continue;
      const std::string words = with_minus_sign(edge.label);
      write(labels.beside_line(segment(edge), words), words, palette::kQuietText);
    }
  }

  /// The shortest first, which have fewest places for their labels.
  std::vector<WireEdge> edges_by_length() const {
    std::vector<WireEdge> edges = figure_.edges;
    std::ranges::stable_sort(edges, {}, [&](const WireEdge& edge) {
      const SeenPoint &a = points_[edge.from], &b = points_[edge.to];
      return std::hypot(a.x - b.x, a.y - b.y);
    });
    return edges;
  }

  FigureScript& script_;
  const PanelBox& panel_;
  const Wireframe& figure_;
  const WireLook& look_;
  double scale_;
  const std::string& name_;
  std::vector<SeenPoint> points_;
  SeenBounds bounds_;
  double nearest_ = 0, farthest_ = 0;
  std::string layers_;
};

}  // namespace

SeenBounds seen_bounds(const Wireframe& figure, const View& view) {
  const std::vector<SeenPoint> points = seen_points(view, figure.points);
  if (points.empty()) return {};
  const auto [left, right] = std::ranges::minmax(points, {}, &SeenPoint::x);
  const auto [bottom, top] = std::ranges::minmax(points, {}, &SeenPoint::y);
  return {left.x, right.x, bottom.y, top.y};
}

void draw_wireframe(FigureScript& script, const PanelBox& panel, const Wireframe& figure,
                    const WireLook& look, double scale, const std::string& name) {
  WirePanel(script, panel, figure, look, scale, name).draw();
}

}  // namespace gcslab
