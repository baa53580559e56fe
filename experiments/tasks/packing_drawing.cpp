#include "experiments/tasks/packing_drawing.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

#include "base/error.h"
#include "packing/packing_problem.h"

namespace gcslab {
namespace {

struct DrawnDisc {
  double x, y, radius;
};

std::vector<DrawnDisc> drawn_discs(const PackingProblem& problem, const Box& solution) {
  std::vector<DrawnDisc> discs;
  for (const RationalDisc& disc : problem.outer)
    discs.push_back({disc.x.get_d(), disc.y.get_d(), disc.radius.get_d()});
  for (std::size_t i = 0; i < solution.size(); i += 3)
    discs.push_back({midpoint(solution[i]), midpoint(solution[i + 1]), midpoint(solution[i + 2])});
  return discs;
}

/// A regular polygon whose edges leave the circle by less than a line's width.
Json circle(const DrawnDisc& disc, double window, const char* kind, const char* style) {
  const int corners = std::clamp(static_cast<int>(150 * std::sqrt(disc.radius / window)), 12, 180);
  Json points = Json::array();
  for (int i = 0; i <= corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners;
    points.push_back({disc.x + disc.radius * std::cos(angle), disc.y + disc.radius * std::sin(angle)});
  }
  return {{"kind", kind}, {"style", style}, {"points", points}};
}

Json segment(const DrawnDisc& a, const DrawnDisc& b) {
  return {{"kind", "polyline"}, {"style", "muted"}, {"points", {{a.x, a.y}, {b.x, b.y}}}};
}

/// The range of one coordinate over the inner discs with a margin.
Json window(const std::vector<DrawnDisc>& discs, double DrawnDisc::*coordinate, double margin) {
  double lower = std::numeric_limits<double>::infinity(), upper = -lower;
  for (auto disc = discs.begin() + 3; disc != discs.end(); ++disc) {
    lower = std::min(lower, (*disc).*coordinate - disc->radius);
    upper = std::max(upper, (*disc).*coordinate + disc->radius);
  }
  return {lower - margin, upper + margin};
}

}  // namespace

Json packing_drawing(const SystemFunctions& functions, const SearchResult& found) {
  if (found.solutions.size() != 1) return nullptr;
  std::optional<PackingProblem> problem;
  try {
    problem = recognise_packing(functions);
  } catch (const NotApplicable&) {
    return nullptr;
  }
  const std::vector<DrawnDisc> discs = drawn_discs(*problem, found.solutions.front().root.box);
  const double smallest =
      std::min({discs[0].radius, discs[1].radius, discs[2].radius});  // the gap is about as large
  Json shapes = Json::array();
  for (std::size_t v = 0; v < discs.size(); ++v) {
    const bool outer = is_outer(static_cast<int>(v));
    shapes.push_back(circle(discs[v], smallest, outer ? "polyline" : "polygon", outer ? "axis" : "hull"));
  }
  for (const auto& [u, v] : problem->graph.edges())
    shapes.push_back(segment(discs[static_cast<std::size_t>(u)], discs[static_cast<std::size_t>(v)]));
  Json panel = {{"title", fmt::format("{} unknowns, {} discs", functions.variables(), discs.size() - 3)},
                {"x", window(discs, &DrawnDisc::x, 0.05 * smallest)},
                {"y", window(discs, &DrawnDisc::y, 0.05 * smallest)},
                {"aspect", "equal"},
                {"frame", false},
                {"shapes", shapes}};
  return {{"panels", Json::array({panel})}};
}

}  // namespace gcslab
