#include "experiments/reporting/cover_drawing.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <utility>

#include "experiments/reporting/cell_outline.h"
#include "experiments/reporting/palette.h"

namespace gcslab {
namespace {

constexpr double kLongestAspect = 3;
/// What the curve is simplified to, as a share of the domain: 0.02 mm in a panel of 80 mm.
constexpr double kCurveTolerance = 1.0 / 4000;

/// The leaves of a cover on the grid of its finest cells.
struct CoverGrid {
  explicit CoverGrid(const CoverTree& tree) : domain(tree.domain()), size(std::ldexp(1.0, tree.depth())) {
    tree.for_each_leaf([this](const CoverLeaf& leaf) {
      const GridRectangle place = {index(0, leaf.box[0].lower), index(1, leaf.box[1].lower),
                                   index(0, leaf.box[0].upper), index(1, leaf.box[1].upper)};
      if (leaf.kept) {
        kept.push_back({place.x0, place.y0});
      } else {
        dropped.push_back(place);
      }
    });
  }

  /// Cells are cut at midpoints, so their corners lie on the grid up to rounding.
  std::int64_t index(std::size_t variable, double value) const {
    const Interval& side = domain[variable];
    return std::llround((value - side.lower) / (side.upper - side.lower) * size);
  }

  std::string point_line(const GridPoint& point) const {
    return plot_number(coordinate(0, point[0])) + " " + plot_number(coordinate(1, point[1])) + "\n";
  }

  double coordinate(std::size_t variable, std::int64_t at) const {
    const Interval& side = domain[variable];
    return side.lower + (side.upper - side.lower) * (static_cast<double>(at) / size);
  }

  const Box& domain;
  double size;  ///< cells a side
  std::vector<GridCell> kept;
  std::vector<GridRectangle> dropped;
};

std::string polygon_lines(const CoverGrid& grid) {
  std::string lines;
  for (const GridPolygon& polygon : outline(grid.kept)) {
    if (!lines.empty()) lines += "\n";
    for (const GridPoint& corner : polygon) lines += grid.point_line(corner);
    lines += grid.point_line(polygon.front());
  }
  return lines;
}

std::string border_lines(const CoverGrid& grid) {
  std::string lines;
  for (const GridSegment& segment : borders(grid.dropped)) {
    if (!lines.empty()) lines += "\n";
    lines += grid.point_line(segment.from) + grid.point_line(segment.to);
  }
  return lines;
}

std::string curve_lines(const std::vector<Polyline>& curve, const Box& domain) {
  const double tolerance =
      kCurveTolerance * std::max(domain[0].upper - domain[0].lower, domain[1].upper - domain[1].lower);
  std::string lines;
  for (const Polyline& line : curve) {
    if (!lines.empty()) lines += "\n";
    for (const Point& p : simplified(line, tolerance))
      lines += plot_number(p[0]) + " " + plot_number(p[1]) + "\n";
  }
  return lines;
}

std::string axis_lines(const Box& domain, const CoverStyle& style) {
  std::string lines;
  for (const auto& [variable, letter] : {std::pair{0U, 'x'}, std::pair{1U, 'y'}}) {
    const Interval& side = domain[variable];
    lines += fmt::format("set {}range [{}:{}]\n", letter, side.lower, side.upper);
    const char* format = letter == 'x' || style.vertical_tics ? "%.3g" : "";
    lines += fmt::format("set format {} '{}'\n", letter, format);
    lines += fmt::format("set {}tics ({}, {}, {})\n", letter, side.lower, midpoint(side), side.upper);
  }
  lines.pop_back();
  return lines;
}

double distance_to_line(const Point& p, const Point& a, const Point& b) {
  const double dx = b[0] - a[0];
  const double dy = b[1] - a[1];
  const double length = std::hypot(dx, dy);
  if (length == 0) return std::hypot(p[0] - a[0], p[1] - a[1]);
  return std::abs(dx * (p[1] - a[1]) - dy * (p[0] - a[0])) / length;
}

}  // namespace

double panel_aspect(const Box& domain) {
  const double aspect = (domain[1].upper - domain[1].lower) / (domain[0].upper - domain[0].lower);
  return aspect > kLongestAspect || aspect < 1 / kLongestAspect ? 1 : aspect;
}

Polyline simplified(const Polyline& line, double tolerance) {
  if (line.size() < 3) return line;
  std::vector<bool> keep(line.size(), false);
  keep.front() = keep.back() = true;
  std::vector<std::pair<std::size_t, std::size_t>> open = {{0, line.size() - 1}};
  while (!open.empty()) {
    const auto [first, last] = open.back();
    open.pop_back();
    std::size_t farthest = first;
    double distance = tolerance;
    for (std::size_t i = first + 1; i < last; ++i) {
      const double d = distance_to_line(line[i], line[first], line[last]);
      if (d > distance) {
        distance = d;
        farthest = i;
      }
    }
    if (farthest == first) continue;
    keep[farthest] = true;
    open.emplace_back(first, farthest);
    open.emplace_back(farthest, last);
  }
  Polyline result;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (keep[i]) result.push_back(line[i]);
  }
  return result;
}

void draw_cover(FigureScript& figure, const PanelBox& panel, const CoverTree& tree,
                const std::vector<Polyline>& curve, const CoverStyle& style, const std::string& name) {
  const CoverGrid grid(tree);
  std::vector<std::string> layers;
  const auto add_layer = [&](const char* what, const std::string& lines, const std::string& with) {
    if (lines.empty()) return;
    layers.push_back(
        fmt::format("data index {} using 1:2 with {}", figure.add_data(name + ", " + what, lines), with));
  };
  if (style.visited) {
    add_layer("borders of visited cells", border_lines(grid),
              fmt::format("lines lw 0.2 lc rgb '{}'", palette::kVisited));
  }
  add_layer("kept cells", polygon_lines(grid),
            fmt::format("filledcurves closed fs solid 1 noborder lc rgb '{}'", palette::kKept));
  if (style.curve) add_layer("curve", curve_lines(curve, tree.domain()), "lines lw 0.2 lc rgb '#000000'");
  figure.place(panel);
  figure.command(axis_lines(tree.domain(), style));
  std::string plot = "plot ";
  for (const std::string& layer : layers) plot += (plot.size() > 5 ? ", \\\n  " : "") + layer;
  figure.command(layers.empty() ? "plot NaN" : plot);
}

}  // namespace gcslab
