#include "geometry/object_reader.h"

#include <fmt/format.h>

#include "geometry/numeric_vector.h"
#include "geometry/sketch.h"

namespace gcslab {
namespace {

/// Points nearer to one place, or to a line, than this part of their distances leave no direction to tell.
constexpr double kFlat = 1e-9;

Numbers read_numbers(const YamlNode& node, Universe universe) {
  Numbers numbers;
  for (const YamlNode& item : node.items()) numbers.push_back(item.real());
  if (numbers.size() != dimension(universe))
    node.fail(fmt::format("has {} coordinates; expected {}", numbers.size(), dimension(universe)));
  return numbers;
}

Numbers read_direction(const YamlNode& node, Universe universe) {
  const Numbers direction = next_axis(read_numbers(node, universe), {}, 0);
  if (direction.empty()) node.fail("has no direction: all its coordinates are 0, or one is infinite");
  return direction;
}

std::vector<Numbers> read_points(const YamlNode& node, std::size_t count, Universe universe) {
  std::vector<Numbers> points;
  for (const YamlNode& item : node.items()) points.push_back(read_numbers(item, universe));
  if (points.size() != count) node.fail(fmt::format("has {} points; expected {}", points.size(), count));
  return points;
}

/// Orthonormal vectors from the first of the points towards the others.
std::vector<Numbers> directions_of(const YamlNode& node, const std::vector<Numbers>& points) {
  std::vector<Numbers> axes;
  for (std::size_t k = 1; k < points.size(); ++k) {
    axes.push_back(next_axis(difference(points[k], points[0]), axes, kFlat));
    if (axes.back().empty()) node.fail(k == 1 ? "has two points at one place" : "has its points on a line");
  }
  return axes;
}

Numbers cross(const Numbers& a, const Numbers& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// A point of a line or plane, and vectors along it.
struct Flat {
  Numbers point;
  std::vector<Numbers> along;
};

Flat read_line(const YamlNode& node, Universe universe) {
  if (const auto through = node.find("through")) {
    node.allow_keys({"through"});
    const std::vector<Numbers> points = read_points(*through, 2, universe);
    return {points[0], directions_of(*through, points)};
  }
  node.allow_keys({"point", "direction"});
  return {read_numbers(node.at("point"), universe), {read_direction(node.at("direction"), universe)}};
}

Numbers line_coordinates(const YamlNode& node, Universe universe) {
  const Flat line = read_line(node, universe);
  const Numbers& u = line.along[0];
  if (universe == Universe::space) return joined<double>({nearest_to_origin(line.point, u), u, {}, {}});
  const Numbers normal = {-u[1], u[0]};
  return joined<double>({{}, normal, dot(normal, line.point), {}});
}

Numbers plane_coordinates(const YamlNode& node) {
  Numbers point, normal;
  if (const auto through = node.find("through")) {
    node.allow_keys({"through"});
    const std::vector<Numbers> points = read_points(*through, 3, Universe::space);
    const std::vector<Numbers> along = directions_of(*through, points);
    point = points[0];
    normal = cross(along[0], along[1]);
  } else {
    node.allow_keys({"point", "normal"});
    point = read_numbers(node.at("point"), Universe::space);
    normal = read_direction(node.at("normal"), Universe::space);
  }
  return joined<double>({{}, normal, dot(normal, point), {}});
}

Numbers round_coordinates(const YamlNode& node, Sort sort, Universe universe) {
  const bool has_normal = sort == Sort::circle && universe == Universe::space;
  if (has_normal) {
    node.allow_keys({"centre", "radius", "normal"});
  } else {
    node.allow_keys({"centre", "radius"});
  }
  const YamlNode radius = node.at("radius");
  if (!(radius.real() >= 0)) radius.fail("is negative");
  return joined<double>({read_numbers(node.at("centre"), universe),
                         has_normal ? read_direction(node.at("normal"), universe) : Numbers(),
                         {},
                         radius.real()});
}

}  // namespace

std::vector<double> read_object(const YamlNode& node, Sort sort, Universe universe) {
  switch (sort) {
    case Sort::point:
      return read_numbers(node, universe);
    case Sort::line:
      return line_coordinates(node, universe);
    case Sort::plane:
      return plane_coordinates(node);
    case Sort::circle:
    case Sort::sphere:
      return round_coordinates(node, sort, universe);
  }
  return {};
}

}  // namespace gcslab
