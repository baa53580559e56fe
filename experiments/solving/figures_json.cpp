#include "experiments/solving/figures_json.h"

namespace gcslab {

void add_figures(Json& result, const GeometricSource& source, const SearchResult& found) {
  std::vector<FigureBox> boxes;
  result["figures"] = Json::array();
  for (const Solution& solution : found.solutions) {
    std::vector<double> point;
    for (const Interval& side : solution.root.box) point.push_back(midpoint(side));
    const Figure figure = figure_at(source.equations, point);
    Json entry = Json::object();
    for (std::size_t p = 0; p < figure.size(); ++p) entry[source.system.points[p]] = figure[p];
    result["figures"].push_back(std::move(entry));
    boxes.push_back(figure_box(source.equations, solution.root.box));
  }
  result["classes"] = congruence_classes(boxes);
}

void add_paths(Json& result, const std::vector<FollowedPath>& paths) {
  result["paths"] = Json::array();
  for (const auto& [path, solutions] : paths) {
    Json crossings = Json::array();
    for (std::size_t k = 0; k < path.crossings.size(); ++k)
      crossings.push_back({{"length", path.crossings[k].length}, {"solution", solutions[k]}});
    result["paths"].push_back({{"type", std::string(name_of(path.end))},
                               {"other_end", std::string(name_of(path.other_end))},
                               {"length", path.length},
                               {"steps", path.steps},
                               {"refused_steps", path.refused},
                               {"crossings", std::move(crossings)}});
  }
}

}  // namespace gcslab
