#include "experiments/solving/wireframe.h"

#include <algorithm>
#include <fmt/format.h>
#include <numbers>
#include <optional>

#include "geometry/sketch.h"

namespace gcslab {
namespace {

using Points = std::vector<std::size_t>;

bool joins(const WireEdge& edge, std::size_t a, std::size_t b) {
  return (edge.from == a && edge.to == b) || (edge.from == b && edge.to == a);
}

void add_guide(Wireframe& wires, std::size_t a, std::size_t b) {
  const auto is_there = [&](const WireEdge& edge) { return joins(edge, a, b); };
  if (a != b && std::ranges::none_of(wires.edges, is_there))
    wires.edges.push_back({.from = a, .to = b, .is_guide = true});
}

/// The pairs of points that a constraint without a length speaks of.
void add_guides(Wireframe& wires, const Constraint& constraint) {
  const Points& p = constraint.objects;
  if (!constraint.kind->is_about_points()) return;
  const std::string& kind = constraint.kind->name;
  if (kind == "collinear" || kind == "angle") {
    for (std::size_t i = 1; i < p.size(); ++i) add_guide(wires, p[i - 1], p[i]);
  } else if (constraint.kind->is_about_pairs) {
    for (std::size_t i = 1; i < p.size(); i += 2) add_guide(wires, p[i - 1], p[i]);
  }
}

/// The sets of points that are coplanar, those with three common points put together: they span one plane.
std::vector<Points> planes(const ConstraintSystem& system) {
  std::vector<Points> result;
  for (const Constraint& constraint : system.constraints) {
    if (constraint.kind->name != "coplanar") continue;
    Points points = constraint.objects;
    std::ranges::sort(points);
    for (auto other = result.begin(); other != result.end();) {
      Points common, all;
      std::ranges::set_intersection(points, *other, std::back_inserter(common));
      if (common.size() < 3) {
        ++other;
        continue;
      }
      std::ranges::set_union(points, *other, std::back_inserter(all));
      points = std::move(all);
      result.erase(other);
      other = result.begin();
    }
    result.push_back(std::move(points));
  }
  return result;
}

Points neighbours(const Wireframe& wires, std::size_t point, const Points& among) {
  Points result;
  for (const WireEdge& edge : wires.edges) {
    if (edge.is_guide || (edge.from != point && edge.to != point)) continue;
    const std::size_t other = edge.from == point ? edge.to : edge.from;
    if (std::ranges::find(among, other) != among.end()) result.push_back(other);
  }
  return result;
}

/// The points in the order of the cycle that the edges between them are; nothing when they are none.
std::optional<Points> cycle(const Wireframe& wires, const Points& points) {
  Points result = {points.front()};
  while (result.size() <= points.size()) {
    const Points next = neighbours(wires, result.back(), points);
    if (next.size() != 2) return std::nullopt;
    const bool is_way_back = result.size() > 1 && next[0] == result[result.size() - 2];
    result.push_back(next[is_way_back ? 1 : 0]);
    if (result.back() == result.front()) break;
  }
  result.pop_back();
  if (result.size() != points.size()) return std::nullopt;
  return result;
}

}  // namespace

Wireframe wireframe_of(const ConstraintSystem& system, const Valuation& valuation) {
  const std::vector<double> values = values_of(valuation);
  Wireframe wires;
  for (std::size_t p = 0; p < system.points(); ++p) wires.names.push_back(system.objects[p].name);
  for (const Constraint& constraint : system.constraints) {
    if (constraint.kind->name != "distance" || !constraint.kind->is_about_points()) continue;
    const std::size_t parameter = *constraint.parameter;
    wires.edges.push_back({constraint.objects[0], constraint.objects[1],
                           fmt::format("{} = {:.6g}", system.parameters[parameter], values[parameter])});
  }
  for (const Constraint& constraint : system.constraints) {
    add_guides(wires, constraint);
    if (constraint.kind->name != "angle" || !constraint.kind->is_about_points()) continue;
    const std::size_t parameter = *constraint.parameter;
    wires.angles.push_back({constraint.objects[1], constraint.objects[0], constraint.objects[2],
                            fmt::format("{} = {:.4g}°", system.parameters[parameter],
                                        values[parameter] * 180 / std::numbers::pi)});
  }
  for (const Points& plane : planes(system)) {
    if (const std::optional<Points> face = cycle(wires, plane)) wires.faces.push_back(*face);
  }
  return wires;
}

Figure reflected_upright(Figure figure, const Frame& frame) {
  if (frame.empty()) return figure;
  for (std::size_t axis = 0; axis < figure.front().size(); ++axis) {
    std::optional<double> first;
    if (axis + 1 < frame.size()) first = figure[frame[axis + 1]][axis];
    for (std::size_t p = 0; p < figure.size() && (!first || *first == 0); ++p) first = figure[p][axis];
    if (*first >= 0) continue;
    for (std::vector<double>& point : figure) point[axis] = 0 - point[axis];
  }
  return figure;
}

}  // namespace gcslab
