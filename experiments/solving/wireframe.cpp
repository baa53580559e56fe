#include "experiments/solving/wireframe.h"

#include <algorithm>
#include <array>
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

std::string degrees_text(double radians) { return fmt::format("{:.4g}°", radians * 180 / std::numbers::pi); }

bool is_angle(const Constraint& constraint) { return constraint.kind->name == "angle"; }

/// "h0 = 1.3", "a = 60°".
std::string label_of(const ConstraintSystem& system, const Constraint& constraint,
                     const std::vector<double>& values) {
  const double value = values[*constraint.parameter];
  return fmt::format("{} = {}", system.parameters[*constraint.parameter],
                     is_angle(constraint) ? degrees_text(value) : fmt::format("{:.6g}", value));
}

/// An edge, an angle or a measure; nothing for the others, and for coordinates that are given.
void add_metric(Wireframe& wires, const Constraint& constraint, const std::string& label) {
  static constexpr std::array kDrawn = {"distance", "angle", "radius", "area", "volume"};
  const Points& objects = constraint.objects;
  const std::string& kind = constraint.kind->name;
  if (constraint.kind->is_about_points() && kind == "distance") {
    wires.edges.push_back({objects[0], objects[1], label});
  } else if (constraint.kind->is_about_points() && kind == "angle") {
    wires.angles.push_back({objects[1], objects[0], objects[2], label});
  } else if (std::ranges::find(kDrawn, kind) != kDrawn.end()) {
    wires.measures.push_back({kind, objects, label});
  }
}

/// The object mirrored along an axis.
void reflect(std::vector<double>& object, Sort sort, Universe universe, std::size_t axis) {
  ObjectParts<double> parts = parts_of(sort, universe, object);
  if (!parts.position.empty()) parts.position[axis] = 0 - parts.position[axis];
  if (!parts.direction.empty()) parts.direction[axis] = 0 - parts.direction[axis];
  object = joined(parts);
}

Universe universe_of(const std::vector<double>& place, Sort sort) {
  const bool is_flat =
      exists_in(sort, Universe::plane) && coordinate_names(sort, Universe::plane).size() == place.size();
  return is_flat ? Universe::plane : Universe::space;
}

}  // namespace

Universe Wireframe::universe() const {
  if (!points.empty()) return universe_of(points.front(), Sort::point);
  return objects.empty() ? Universe::space : universe_of(objects.front().place, objects.front().sort);
}

Figure Wireframe::figure() const {
  Figure result = points;
  for (const WireObject& object : objects) result.push_back(object.place);
  return result;
}

std::vector<Sort> Wireframe::sorts() const {
  std::vector<Sort> result(names.size(), Sort::point);
  for (const WireObject& object : objects) result.push_back(object.sort);
  return result;
}

Wireframe Wireframe::at(const Figure& figure) const {
  Wireframe result = *this;
  result.points.assign(figure.begin(), figure.begin() + static_cast<std::ptrdiff_t>(names.size()));
  if (figure.size() == names.size()) result.objects.clear();
  for (std::size_t k = 0; k < result.objects.size(); ++k) result.objects[k].place = figure[names.size() + k];
  return result;
}

Wireframe wireframe_of(const ConstraintSystem& system, const Valuation& valuation) {
  const std::vector<double> values = values_of(valuation);
  Wireframe wires;
  for (std::size_t p = 0; p < system.points(); ++p) wires.names.push_back(system.objects[p].name);
  for (std::size_t k = system.points(); k < system.objects.size(); ++k)
    wires.objects.push_back({system.objects[k].name, system.objects[k].sort});
  for (const Constraint& constraint : system.constraints) {
    if (constraint.parameter) add_metric(wires, constraint, label_of(system, constraint, values));
  }
  for (const Constraint& constraint : system.constraints) add_guides(wires, constraint);
  for (const Points& plane : planes(system)) {
    if (const std::optional<Points> face = cycle(wires, plane)) wires.faces.push_back(*face);
  }
  return wires;
}

Figure reflected_upright(Figure figure, const std::vector<Sort>& sorts, const Frame& frame) {
  if (frame.empty()) return figure;
  const Universe universe = universe_of(figure[frame.front()], Sort::point);
  for (std::size_t axis = 0; axis < dimension(universe); ++axis) {
    double first = axis + 1 < frame.size() ? figure[frame[axis + 1]][axis] : 0;
    for (std::size_t k = 0; k < figure.size() && first == 0; ++k) {
      const ObjectParts<double> parts = parts_of(sorts[k], universe, figure[k]);
      if (!parts.position.empty()) first = parts.position[axis];
    }
    if (first >= 0) continue;
    for (std::size_t k = 0; k < figure.size(); ++k) reflect(figure[k], sorts[k], universe, axis);
  }
  return figure;
}

}  // namespace gcslab
