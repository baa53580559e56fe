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

bool has_curves(const Problem& problem) {
  return problem.system.variables.size() == 2 && std::ranges::all_of(problem.system.box, is_bounded);
}

}  // namespace

void check_picture_file(const std::filesystem::path& file) {
  if (file.extension() != ".svg" && file.extension() != ".pdf") {
    throw InputError("--figure " + file.string() + ": the name must end in .svg or .pdf");
  }
  check_writable(file);
}

void check_cover_picture(const Problem& problem, const std::filesystem::path& file) {
  if (problem.system.variables.size() != 2) {
    throw InputError("--figure: covers are drawn of plane curves only, and this problem has " +
                     std::to_string(problem.system.variables.size()) + " variables");
  }
  for (const Interval& side : problem.system.box) {
    if (!(side.lower < side.upper))
      throw InputError("--figure: the box is flat; a picture needs two sides of positive width");
  }
  check_picture_file(file);
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
  const ProblemCurves curves = traced_curves(problem);
  draw_cover(figure, panel, tree, first_curve(curves), CoverStyle{}, title);
  const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
  write_figure(figure, "Cover of " + title, folder, file.stem().string(),
               {file.extension().string().substr(1)});
}

ProblemCurves traced_curves(const Problem& problem) {
  ProblemCurves curves;
  if (!has_curves(problem)) return curves;
  const auto trace = [&](Expression function) {
    return trace_curve(function, problem.system.box, kTraceResolution);
  };
  for (const Expression equation : problem.system.equations) curves.equations.push_back(trace(equation));
  for (const Expression border : problem.system.inequalities) curves.inequalities.push_back(trace(border));
  return curves;
}

CurveSource corpus_curves() {
  auto known = std::make_shared<std::map<std::string, ProblemCurves>>();
  return [known](const std::string& name) {
    const auto found = known->find(name);
    if (found != known->end()) return found->second;
    return (*known)[name] = traced_curves(load_problem(Corpus::standard().problem_path(name)));
  };
}

}  // namespace gcslab
