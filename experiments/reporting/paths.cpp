// Figure kind paths: homotopy paths, one curve a job: two unknowns and t in a box, or one unknown against t.

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/nearest_name.h"
#include "experiments/reporting/figure_registry.h"
#include "experiments/reporting/path_drawing.h"
#include "experiments/reporting/path_rows.h"
#include "experiments/reporting/view_option.h"

namespace gcslab {
namespace {

class PathsFigure {
 public:
  explicit PathsFigure(const FigureRequest& request)
      : request_(request), reach_(request.options.real("reach")) {}

  FigureScript draw() {
    picture_.unknowns = {request_.options.word("x"), request_.options.word("y")};
    const bool is_flat = picture_.unknowns[1].empty();
    check_bold();
    for (const PathRow& row : path_rows(request_)) add(row);
    FigureScript script = draw_paths(
        picture_, {width_from(request_.options), view_from(request_).value_or(View{-32, 18}), is_flat});
    if (is_cut_) script.notes.push_back("Curves that lead farther are cut off.");
    for (std::string& note : notes_on_missing(request_.rows)) script.notes.push_back(std::move(note));
    return script;
  }

 private:
  [[noreturn]] void fail(const std::string& message) const {
    throw InputError(request_.item.where, "'" + request_.item.file + "': " + message);
  }

  void check_bold() const {
    const std::string& bold = request_.options.word("bold");
    const auto is_bold = [&](const Row* row) { return row->at("method") == bold; };
    if (!bold.empty() && std::ranges::none_of(request_.rows, is_bold))
      fail("bold: '" + bold + "' is no method of this figure");
  }

  std::size_t number_of(const TracedPath& path, const std::string& unknown) const {
    const auto found = std::ranges::find(path.names, unknown);
    if (found == path.names.end()) fail(unknown_name_message("unknown", unknown, path.names));
    return static_cast<std::size_t>(found - path.names.begin());
  }

  void add(const PathRow& row) {
    const std::size_t x = number_of(row.path, picture_.unknowns[0]);
    const std::size_t y = picture_.unknowns[1].empty() ? x : number_of(row.path, picture_.unknowns[1]);
    const auto place = [&](const TracedPoint& point) {
      return PathPoint{point.unknowns[x], point.unknowns[y], point.t};
    };
    const PathPoint sketch = place(row.path.points[row.path.sketch]);
    const auto is_near = [&](const PathPoint& p) {
      return reach_ == 0 || (std::abs(p[0] - sketch[0]) <= reach_ && std::abs(p[1] - sketch[1]) <= reach_);
    };
    const auto add_marks = [&](const std::vector<TracedPoint>& points, std::vector<PathPoint>& marks) {
      for (const TracedPoint& point : points) {
        if (is_near(place(point))) marks.push_back(place(point));
      }
    };
    PathCurve curve{row.name, {}, row.row->at("method") == request_.options.word("bold")};
    std::size_t first = row.path.sketch, last = row.path.sketch;  // the part in reach
    while (first > 0 && is_near(place(row.path.points[first - 1]))) --first;
    while (last + 1 < row.path.points.size() && is_near(place(row.path.points[last + 1]))) ++last;
    is_cut_ = is_cut_ || first > 0 || last + 1 < row.path.points.size();
    for (std::size_t i = first; i <= last; ++i) curve.points.push_back(place(row.path.points[i]));
    picture_.curves.push_back(std::move(curve));
    picture_.sketches.push_back(sketch);
    add_marks(row.path.crossings, picture_.solutions);
    add_marks(row.path.critical, picture_.critical);
  }

  const FigureRequest& request_;
  double reach_;
  PathPicture picture_;
  bool is_cut_ = false;
};

}  // namespace

FigureKind paths_kind() {
  return {
      "paths",
      "homotopy paths of jobs with traced_points, one curve a job: two unknowns and t in a box, or one "
      "unknown against t",
      {{.name = "x", .meaning = "an unknown, such as P5_y", .default_value = std::string()},
       {.name = "y",
        .meaning = "a second unknown; empty: t stands upright above the first one",
        .default_value = std::string()},
       {.name = "bold",
        .meaning = "the label of a method whose curves are bold",
        .default_value = std::string()},
       real_option("reach",
                   "a curve is drawn as far as the unknowns shown are within this of the sketch's; 0: all",
                   "", 0, 0, 1e12),
       view_option("-32,18"),
       width_option("column")},
      [](const FigureRequest& request) { return PathsFigure(request).draw(); }};
}

}  // namespace gcslab
