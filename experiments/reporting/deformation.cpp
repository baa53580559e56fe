// Figure kind deformation: figures along the homotopy path of a job, at equal distances on it.

#include <cmath>
#include <fmt/format.h>

#include "base/error.h"
#include "experiments/reporting/figure_registry.h"
#include "experiments/reporting/number_format.h"
#include "experiments/reporting/path_rows.h"
#include "experiments/reporting/view_option.h"
#include "experiments/reporting/wireframe_table.h"

namespace gcslab {
namespace {

double distance_of(const TracedPoint& a, const TracedPoint& b) {
  double sum = (a.t - b.t) * (a.t - b.t);
  for (std::size_t i = 0; i < a.unknowns.size(); ++i)
    sum += (a.unknowns[i] - b.unknowns[i]) * (a.unknowns[i] - b.unknowns[i]);
  return std::sqrt(sum);
}

/// `count` points (at least 2), the first and the last among them, at equal distances on the path.
std::vector<const TracedPoint*> spread_points(const std::vector<TracedPoint>& points, std::size_t count) {
  std::vector<double> lengths = {0};
  for (std::size_t i = 1; i < points.size(); ++i)
    lengths.push_back(lengths.back() + distance_of(points[i - 1], points[i]));
  std::vector<const TracedPoint*> result;
  std::size_t i = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const double wanted = lengths.back() * static_cast<double>(k) / static_cast<double>(count - 1);
    while (i + 1 < points.size() && lengths[i] < wanted) ++i;
    result.push_back(&points[i]);
  }
  result.back() = &points.back();
  return result;
}

FigureScript draw_deformation(const FigureRequest& request) {
  const std::vector<PathRow> rows = path_rows(request);
  if (rows.size() != 1)
    throw InputError(request.item.where,
                     "'" + request.item.file + "': a deformation is that of one job; choose it by a filter");
  const PathRow& row = rows.front();
  const auto count = static_cast<std::size_t>(request.options.integer("count"));
  std::vector<CaptionedFigure> figures;
  for (const TracedPoint* point : spread_points(row.path.points, count)) {
    figures.push_back({row.picture.wires.at(row.path.figure(*point)),
                       with_minus_sign(fmt::format("t = {:.2f}", point->t))});
  }
  WireTableStyle style;
  style.width = width_from(request.options);
  style.view = view_from(request);
  FigureScript script =
      draw_strip(figures, static_cast<std::size_t>(request.options.integer("per_line")), style);
  script.notes.push_back(fmt::format("{} figures at equal distances on the path.", count));
  script.notes.emplace_back("Nearer edges are darker and thicker.");
  return script;
}

}  // namespace

FigureKind deformation_kind() {
  return {"deformation",
          "figures along the homotopy path of one job with traced_points, with their t below",
          {integer_option("count", "of figures", "", 8, 2, 60),
           integer_option("per_line", "at most", "", 4, 1, 12), view_option("best"), width_option("page")},
          draw_deformation};
}

}  // namespace gcslab
