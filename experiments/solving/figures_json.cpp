#include "experiments/solving/figures_json.h"

#include "experiments/solving/figure_picture.h"

namespace gcslab {

void add_figures(Json& result, const GeometricSource& source, const SearchResult& found) {
  result["figures"] = Json::array();
  for (const Solution& solution : found.solutions) {
    std::vector<double> point;
    for (const Interval& side : solution.root.box) point.push_back(midpoint(side));
    const Figure figure = figure_at(source.equations, point);
    Json entry = Json::object();
    for (std::size_t p = 0; p < figure.size(); ++p) entry[source.system.objects[p].name] = figure[p];
    result["figures"].push_back(std::move(entry));
  }
  result["classes"] = classes_of(source, found);
}

void add_paths(Json& result, const std::vector<FollowedPath>& paths) {
  result["paths"] = Json::array();
  for (const FollowedPath& followed : paths) {
    const Path& path = followed.found.path;
    Json crossings = Json::array();
    for (std::size_t k = 0; k < path.crossings.size(); ++k) {
      crossings.push_back({{"length", path.crossings[k].length},
                           {"solution", followed.numbers[followed.found.solution_of_crossing[k]]}});
      if (k < followed.crossing_events.size() && !followed.crossing_events[k].empty())
        crossings.back()["event"] = followed.crossing_events[k];
      if (path.crossings[k].is_touching) crossings.back()["touching"] = true;
    }
    Json critical = Json::array();
    for (std::size_t k = 0; k < path.branch_points.size(); ++k) {
      critical.push_back({{"length", path.branch_points[k].length},
                          {"t", path.branch_points[k].v.back()},
                          {"configuration", followed.explanation.branch_points[k]}});
    }
    result["paths"].push_back({{"type", std::string(name_of(path.end))},
                               {"other_end", std::string(name_of(path.other_end))},
                               {"length", path.length},
                               {"steps", path.steps},
                               {"refused_steps", path.refused},
                               {"precise_steps", path.precise_steps},
                               {"restarts", path.restarts},
                               {"crossings", std::move(crossings)},
                               {"critical", std::move(critical)},
                               {"configuration", followed.explanation.end},
                               {"other_configuration", followed.explanation.other_end}});
    for (const auto& [key, text] : {std::pair("escape", &followed.escape),
                                    {"other_escape", &followed.other_escape},
                                    {"plan_event", &followed.plan_event},
                                    {"other_plan_event", &followed.other_plan_event}}) {
      if (!text->empty()) result["paths"].back()[key] = *text;
    }
    if (!followed.origin.empty()) result["paths"].back()["sketch"] = followed.origin;
    if (path.tubes > 0) {
      Json& entry = result["paths"].back();
      entry["tubes"] = path.tubes;
      entry["unproved_steps"] = path.unproved_steps;
      entry["return_proved"] = path.is_return_proved;
    }
    for (std::size_t k = 0; k < followed.found.solutions.size(); ++k) {
      const SketchSolution& solution = followed.found.solutions[k];
      if (solution.root) continue;
      Json& entry = result["solutions"][followed.numbers[k]];
      if (entry["certificate"]["claim"] != "none") continue;  // certified on another path
      entry["jacobian_rank"] = solution.rank;
      entry["on_continuum"] = solution.is_on_continuum;
    }
  }
}

void add_plan(Json& result, const PlanReport& plan) {
  Json& entry = result["plan"];
  entry = {
      {"text", plan.lines}, {"guides", plan.guides}, {"choices", plan.choices}, {"removed", plan.removed}};
  entry.update(to_json(plan.diagram));
  if (plan.branches) entry["branches"] = *plan.branches;
  if (plan.empty_branches) entry["empty_branches"] = *plan.empty_branches;
  if (plan.sketches) entry["sketches"] = *plan.sketches;
  if (plan.unread) entry["unread_solutions"] = *plan.unread;
  if (plan.plans) entry["plans"] = *plan.plans;
  if (plan.plan_changes) entry["plan_changes"] = *plan.plan_changes;
  if (plan.branch_changes) entry["branch_changes"] = *plan.branch_changes;
  if (!plan.escapes) return;
  entry["escapes"] = Json::array();
  for (const PlanReport::Escape& escape : *plan.escapes) {
    entry["escapes"].push_back(
        {{"objects", {escape.object}}, {"guides", escape.guides}, {"configuration", escape.configuration}});
  }
}

}  // namespace gcslab
