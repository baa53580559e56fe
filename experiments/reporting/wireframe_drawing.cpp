#include "experiments/reporting/wireframe_drawing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <optional>

#include "experiments/reporting/depth_shades.h"
#include "experiments/reporting/label_placement.h"
#include "experiments/reporting/number_format.h"
#include "experiments/reporting/palette.h"
#include "experiments/reporting/seen_measures.h"

namespace gcslab {
namespace {

constexpr double kGap = 0.6;  // half of what is hidden behind a perpendicular edge, in millimetres
constexpr std::string_view kCurveColour = palette::kBlue;  // lines, circles, spheres
constexpr std::string_view kPlaneColour = palette::kOrange;
constexpr std::string_view kPlaneText = "#9A6A00";  // dark enough on white

/// What looks alike.
enum class Family { edges, curves, planes };
constexpr std::array kFamilies = {Family::edges, Family::curves, Family::planes};

const Shades& shades_of(Family family) {
  static const Shades curves = gcslab::shades_of(kCurveColour, 1.1);
  static const Shades planes = gcslab::shades_of(kPlaneColour, 0.8);
  return family == Family::edges ? edge_shades() : family == Family::curves ? curves : planes;
}
std::string_view name_of(Family family) {
  return family == Family::edges ? "edges" : family == Family::curves ? "curves" : "planes";
}

/// A polyline of the drawing.
struct DrawnLine {
  std::vector<SeenPoint> points;
  Family family = Family::edges;
  bool is_guide = false;
  std::optional<std::size_t> object{};  ///< number among the seen ones, where it is the outline of one
};

std::vector<SeenPoint> all_points(const std::vector<SeenPoint>& points,
                                  const std::vector<SeenObject>& objects,
                                  const std::vector<SeenMeasure>& measures) {
  std::vector<SeenPoint> all = points;
  for (const SeenObject& object : objects)
    all.insert(all.end(), object.outline.begin(), object.outline.end());
  for (const SeenMeasure& measure : measures) {
    for (const auto& guide : measure.guides) all.insert(all.end(), guide.begin(), guide.end());
  }
  if (all.empty()) all.emplace_back();
  return all;
}

SeenBounds bounds_of(const std::vector<SeenPoint>& points) {
  const auto [left, right] = std::ranges::minmax(points, {}, &SeenPoint::x);
  const auto [bottom, top] = std::ranges::minmax(points, {}, &SeenPoint::y);
  return {left.x, right.x, bottom.y, top.y};
}

DepthScale depth_scale_of(const std::vector<SeenPoint>& points, const SeenBounds& bounds) {
  const auto [near, far] = std::ranges::minmax(points, {}, &SeenPoint::away);
  return {near.away, far.away, std::max(bounds.width(), bounds.height())};
}

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
        objects_(seen_objects(figure, look.view)),
        measures_(gcslab::shows_values(figure, look) ? seen_measures(figure, look.view)
                                                     : std::vector<SeenMeasure>()),
        bounds_(bounds_of(all_points(points_, objects_, measures_))),
        depths_(depth_scale_of(all_points(points_, objects_, {}), bounds_)) {}

  void draw() {
    add_faces();
    add_surfaces();
    add_guides();
    add_lines();
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
  bool shows_values() const { return gcslab::shows_values(figure_, look_); }

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

  /// Planes and spheres, the farthest first.
  void add_surfaces() {
    for (const SeenObject* object : surfaces_from_the_rear(objects_)) {
      std::string lines;
      for (const SeenPoint& p : object->outline) lines += point_line(p.x, p.y);
      add_layer("shade of " + figure_.objects[object->number].name, lines,
                fmt::format("filledcurves closed fs transparent solid 0.13 noborder lc rgb '{}'",
                            object->sort == Sort::plane ? kPlaneColour : palette::kSky));
    }
  }

  /// What shows where something is measured.
  void add_guides() {
    std::string lines;
    for (const SeenMeasure& measure : measures_) {
      for (const auto& [from, to] : measure.guides)
        lines += (lines.empty() ? "" : "\n") + point_line(from.x, from.y) + point_line(to.x, to.y);
    }
    add_layer("what is measured", lines, fmt::format("lines lw 0.5 dt 2 lc rgb '{}'", palette::kQuietText));
  }

  std::vector<DrawnLine> drawn_lines() const {
    std::vector<DrawnLine> lines;
    for (const WireEdge& edge : figure_.edges)
      lines.push_back({{points_[edge.from], points_[edge.to]}, Family::edges, edge.is_guide});
    for (std::size_t k = 0; k < objects_.size(); ++k)
      lines.push_back(
          {objects_[k].outline, objects_[k].sort == Sort::plane ? Family::planes : Family::curves, false, k});
    return lines;
  }

  bool is_hidden(const SeenPoint& point, const std::optional<std::size_t>& own) const {
    return gcslab::is_hidden(point, objects_, own, 1e-3 * std::max(bounds_.width(), bounds_.height()));
  }

  /// In pieces so short that each is hidden or not.
  void shade(const SeenPoint& from, const SeenPoint& to, const std::optional<std::size_t>& own,
             ShadedLines& lines) const {
    constexpr double kPiece = 0.5;  // millimetres
    const bool is_cut = std::ranges::any_of(objects_, &SeenObject::is_surface);
    const double length = scale_ * std::hypot(from.x - to.x, from.y - to.y);
    const auto pieces = is_cut ? static_cast<std::size_t>(std::ceil(length / kPiece)) : 1;
    const auto at = [&](double part) {
      return SeenPoint{from.x + part * (to.x - from.x), from.y + part * (to.y - from.y),
                       from.away + part * (to.away - from.away)};
    };
    for (std::size_t k = 0; k < pieces; ++k) {
      const double begin = static_cast<double>(k) / static_cast<double>(pieces);
      const double end = static_cast<double>(k + 1) / static_cast<double>(pieces);
      lines.add(at(begin), at(end), is_hidden(at((begin + end) / 2), own));
    }
  }

  void add_lines() {
    const std::vector<DrawnLine> drawn = drawn_lines();
    std::vector<std::vector<SeenPoint>> polylines;
    for (const DrawnLine& line : drawn) polylines.push_back(line.points);
    std::string guides;
    std::array<ShadedLines, kFamilies.size()> shaded = {ShadedLines(depths_), ShadedLines(depths_),
                                                        ShadedLines(depths_)};
    for (const VisiblePart& part : visible_parts(polylines, weight() * kGap / scale_)) {
      const DrawnLine& line = drawn[part.line];
      if (line.is_guide && !guides.empty()) guides += "\n";
      for (std::size_t i = 0; line.is_guide && i < part.points.size(); ++i)
        guides += point_line(part.points[i].x, part.points[i].y);
      for (std::size_t i = 1; !line.is_guide && i < part.points.size(); ++i)
        shade(part.points[i - 1], part.points[i], line.object, shaded[static_cast<std::size_t>(line.family)]);
    }
    add_layer("pairs of points without a length", guides, "lines lw 0.5 dt 2 lc rgb '#808080'");
    add_reliefs();
    for (std::size_t k = 0; k < kDepths; ++k) {
      for (const Family family : kFamilies)
        add_shade(family, k, shaded[static_cast<std::size_t>(family)].lines(k));
    }
  }

  void add_shade(Family family, std::size_t number, const std::string& lines) {
    const Shade& shade = shades_of(family)[number];
    add_layer(fmt::format("{}, depth {} of {} from the rear", name_of(family), number + 1, kDepths), lines,
              fmt::format("lines lw {:.3g} lc rgb '{}'", weight() * shade.line_width, shade.colour));
  }

  void add_reliefs() {
    std::string lines;
    for (const SeenObject& object : objects_) {
      if (!object.relief.empty() && !lines.empty()) lines += "\n";
      for (const SeenPoint& p : object.relief) lines += point_line(p.x, p.y);
    }
    add_layer("nearer halves of horizontal great circles", lines,
              fmt::format("lines lw {:.3g} lc rgb '{}'", 0.5 * weight(), palette::kSky));
  }

  void add_points() {
    std::array<std::string, kDepths> lines;
    for (const SeenPoint& p : points_) {
      const std::size_t shade = depths_.number_at(p.away);
      lines[is_hidden(p, std::nullopt) ? veiled(shade) : shade] += point_line(p.x, p.y);
    }
    for (std::size_t k = 0; k < kDepths; ++k) {
      add_layer(fmt::format("points, depth {} from the rear", k + 1), lines[k],
                fmt::format("points pt 7 ps {:.3g} lc rgb '{}'", 0.42 * weight(), edge_shades()[k].colour));
    }
  }

  // ---- angles ----

  /// The angles whose arcs are drawn, with their labels.
  std::vector<std::pair<SeenAngle, std::string>> angles() const {
    std::vector<std::pair<SeenAngle, std::string>> result;
    if (!shows_values()) return result;
    for (const WireAngle& angle : figure_.angles)
      result.push_back({{points_[angle.at], points_[angle.from], points_[angle.to]}, angle.label});
    for (const SeenMeasure& measure : measures_) {
      if (measure.angle) result.emplace_back(*measure.angle, measure.label);
    }
    return result;
  }

  /// The arc of an angle on paper, from its first arm to its second the short way.
  std::vector<PaperPoint> arc(const SeenAngle& angle) const {
    constexpr double kRadius = 4.5;
    constexpr int kParts = 24;
    const PaperPoint at = on_paper(angle.at);
    const auto direction = [&](const SeenPoint& end) {
      const PaperPoint p = on_paper(end);
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
    std::string lines;
    for (const auto& [angle, label] : angles()) {
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

  PaperSegment segment(const std::array<SeenPoint, 2>& piece) const {
    return {on_paper(piece[0]), on_paper(piece[1])};
  }

  LabelPlacer placer() const {
    std::vector<PaperSegment> lines;
    std::vector<PaperPoint> points;
    for (const WireEdge& edge : figure_.edges) lines.push_back(segment(edge));
    for (const SeenObject& object : objects_) {
      for (std::size_t i = 1; i < object.outline.size(); ++i)
        lines.push_back({on_paper(object.outline[i - 1]), on_paper(object.outline[i])});
    }
    for (const SeenMeasure& measure : measures_) {
      for (const auto& guide : measure.guides) lines.push_back(segment(guide));
    }
    for (const SeenPoint& p : points_) points.push_back(on_paper(p));
    for (const auto& [angle, label] : angles()) {
      const std::vector<PaperPoint> curve = arc(angle);
      for (std::size_t i = 1; i < curve.size(); ++i) lines.push_back({curve[i - 1], curve[i]});
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
    if (look_.names) {
      for (const SeenObject& object : objects_) {
        const std::string& name = figure_.objects[object.number].name;
        std::vector<PaperSegment> pieces;
        for (const auto& piece : object.pieces_for_name()) pieces.push_back(segment(piece));
        write(labels.beside_curve(pieces, name), name,
              object.sort == Sort::plane ? kPlaneText : kCurveColour);
      }
    }
    if (!shows_values()) return;
    for (const auto& [angle, label] : angles()) {
      const std::vector<PaperPoint> curve = arc(angle);
      const PaperPoint middle = curve[curve.size() / 2], at = on_paper(angle.at);
      const std::string words = with_minus_sign(label);
      write(labels.beyond_point(middle, {middle[0] - at[0], middle[1] - at[1]}, words), words,
            palette::kVermillion);
    }
    for (const SeenMeasure& measure : measures_) {
      if (measure.angle) continue;
      const std::string words = with_minus_sign(measure.label);
      const PaperSegment guide = segment(measure.guides.front());
      write(measure.middle ? labels.beyond_point(on_paper(*measure.middle), {0, 1}, words)
                           : labels.beside_line(guide, words),
            words, palette::kQuietText);
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
  std::vector<SeenObject> objects_;
  std::vector<SeenMeasure> measures_;
  SeenBounds bounds_;
  DepthScale depths_;
  std::string layers_;
};

}  // namespace

bool shows_values(const Wireframe& figure, const WireLook& look) {
  return look.values && (figure.universe() == Universe::plane || look.dimensions);
}

SeenBounds seen_bounds(const Wireframe& figure, const WireLook& look) {
  return bounds_of(
      all_points(seen_points(look.view, figure.points), seen_objects(figure, look.view),
                 shows_values(figure, look) ? seen_measures(figure, look.view) : std::vector<SeenMeasure>()));
}

void draw_wireframe(FigureScript& script, const PanelBox& panel, const Wireframe& figure,
                    const WireLook& look, double scale, const std::string& name) {
  WirePanel(script, panel, figure, look, scale, name).draw();
}

}  // namespace gcslab
