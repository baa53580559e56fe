#include "experiments/reporting/cover_picture.h"

#include <algorithm>
#include <map>
#include <memory>

#include "base/atomic_file.h"
#include "base/error.h"
#include "covering/curve_trace.h"
#include "experiments/corpus/corpus.h"
#include "experiments/corpus/problem.h"
#include "experiments/reporting/cover_drawing.h"
#include "experiments/reporting/gnuplot.h"
#include "experiments/reporting/number_format.h"
#include "experiments/reporting/palette.h"

namespace gcslab {
namespace {

constexpr int kTraceResolution = 500;
constexpr double kPanelWidth = 76;

bool is_plane_curve(const Problem& problem) {
  return problem.kind == "curve" && problem.system.equations.size() == 1 &&
         std::ranges::all_of(problem.system.box, [](const Interval& side) { return is_bounded(side); });
}

}  // namespace

void check_cover_picture(const Problem& problem, const std::filesystem::path& file) {
  if (file.extension() != ".svg" && file.extension() != ".pdf") {
    throw InputError("--figure " + file.string() + ": the name must end in .svg or .pdf");
  }
  if (problem.system.variables.size() != 2) {
    throw InputError("--figure: covers are drawn of plane curves only, and this problem has " +
                     std::to_string(problem.system.variables.size()) + " variables");
  }
  for (const Interval& side : problem.system.box) {
    if (!(side.lower < side.upper))
      throw InputError("--figure: the box is flat; a picture needs two sides of positive width");
  }
  check_writable(file);
}

void write_cover_picture(const Problem& problem, const CoverTree& tree, const std::string& method,
                         const std::filesystem::path& file) {
  FigureScript figure;
  figure.width = kColumnWidth;
  const double height = kPanelWidth * panel_aspect(tree.domain());
  const PanelBox panel = {6.5, 8, kPanelWidth, height};
  figure.height = height + 13;
  const std::string title = heading_of("problem", problem.name) + ", " + method;
  figure.text(panel.centre(), panel.top() + 2.4, title, {"center", kTitleText});
  const std::string counts = "kept " + format_count(static_cast<double>(tree.kept_cells())) + " of " +
                             format_count(static_cast<double>(tree.visited_cells())) + " visited";
  figure.text(panel.centre(), 2.2, counts, {"center", kSmallText, palette::kQuietText});
  draw_cover(figure, panel, tree, traced_curve(problem), CoverStyle{}, title);
  const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
  write_figure(figure, "Cover of " + title, folder, file.stem().string(),
               {file.extension().string().substr(1)});
}

std::vector<Polyline> traced_curve(const Problem& problem) {
  if (!is_plane_curve(problem)) return {};
  return trace_curve(problem.system.equations.front(), problem.system.box, kTraceResolution);
}

CurveSource corpus_curves() {
  auto known = std::make_shared<std::map<std::string, std::vector<Polyline>>>();
  return [known](const std::string& name) {
    const auto found = known->find(name);
    if (found != known->end()) return found->second;
    return (*known)[name] = traced_curve(load_problem(Corpus::standard().problem_path(name)));
  };
}

}  // namespace gcslab
