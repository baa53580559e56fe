#include "experiments/tasks/packing_drawing.h"

#include <algorithm>
#include <array>
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
Json circle(const DrawnDisc& disc, double window, const char* style) {
  const int corners = std::clamp(static_cast<int>(150 * std::sqrt(disc.radius / window)), 12, 180);
  Json points = Json::array();
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners;
    points.push_back({disc.x + disc.radius * std::cos(angle), disc.y + disc.radius * std::sin(angle)});
  }
  return {{"kind", "polygon"}, {"style", style}, {"points", points}};
}

/// Where two tangent discs touch, seen from the first.
std::array<double, 2> tangency(const DrawnDisc& a, const DrawnDisc& b) {
  const double part = a.radius / (a.radius + b.radius);
  return {a.x + part * (b.x - a.x), a.y + part * (b.y - a.y)};
}

/// The edge of two discs; of an outer one only what lies in the inner disc.
Json edge(const DrawnDisc& inner, const DrawnDisc& other, bool other_is_outer) {
  const std::array<double, 2> end = other_is_outer ? tangency(inner, other) : std::array{other.x, other.y};
  return {{"kind", "polyline"}, {"style", "muted"}, {"points", {{inner.x, inner.y}, {end[0], end[1]}}}};
}

/// The range of one coordinate, 0 or 1, over the gap between the outer discs, with a margin.
Json window(const std::vector<DrawnDisc>& discs, std::size_t coordinate, double margin) {
  const std::array<double, 3> ends = {tangency(discs[0], discs[1])[coordinate],
                                      tangency(discs[1], discs[2])[coordinate],
                                      tangency(discs[2], discs[0])[coordinate]};
  return {std::ranges::min(ends) - margin, std::ranges::max(ends) + margin};
}

Json shapes_of(const Triangulation& graph, const std::vector<DrawnDisc>& discs) {
  const double smallest = std::min({discs[0].radius, discs[1].radius, discs[2].radius});
  Json shapes = Json::array();
  for (std::size_t v = 0; v < discs.size(); ++v)
    shapes.push_back(circle(discs[v], smallest, is_outer(static_cast<int>(v)) ? "cell" : "hull"));
  for (const Edge& ends : graph.edges()) {
    if (is_outer(ends)) continue;  // the smaller number is the first: an outer one, if any
    const auto [u, v] = ends;
    shapes.push_back(
        edge(discs[static_cast<std::size_t>(v)], discs[static_cast<std::size_t>(u)], is_outer(u)));
  }
  return shapes;
}

}  // namespace

Json packing_drawing(const std::string& name, const SystemFunctions& functions, const SearchResult& found) {
  if (found.solutions.size() != 1) return nullptr;
  std::optional<PackingProblem> problem;
  try {
    problem = recognise_packing(functions);
  } catch (const NotApplicable&) {
    return nullptr;
  }
  const std::vector<DrawnDisc> discs = drawn_discs(*problem, found.solutions.front().root.box);
  const double margin = 0.02 * std::min({discs[0].radius, discs[1].radius, discs[2].radius});
  Json panel = {{"title", fmt::format("{}, {} discs", name, discs.size() - 3)},
                {"x", window(discs, 0, margin)},
                {"y", window(discs, 1, margin)},
                {"aspect", "equal"},
                {"frame", false},
                {"shapes", shapes_of(problem->graph, discs)}};
  return {{"panels", Json::array({panel})}};
}

}  // namespace gcslab
