#include "experiments/reporting/cover_drawing.h"

#include <cmath>
#include <fmt/format.h>

#include "experiments/reporting/cell_outline.h"
#include "experiments/reporting/palette.h"

namespace gcslab {
namespace {

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

}  // namespace

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
  figure.command(axis_commands(tree.domain(), style.vertical_tics));
  std::string plot = "plot ";
  for (const std::string& layer : layers) plot += (plot.size() > 5 ? ", \\\n  " : "") + layer;
  figure.command(layers.empty() ? "plot NaN" : plot);
}

}  // namespace gcslab
