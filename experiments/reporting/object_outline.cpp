#include "experiments/reporting/object_outline.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace gcslab {
namespace {

constexpr double kMargin = 0.08;  // of the longest side, on each side

bool is_unbounded(Sort sort) { return sort == Sort::line || sort == Sort::plane; }

Numbers cross(const Numbers& a, const Numbers& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// A position, and how far the figure reaches from it along a direction of length 1.
struct Place {
  Numbers centre;
  double radius = 0;
  Numbers normal{};  ///< of a circle in space

  double reach(const Numbers& direction) const {
    if (normal.empty()) return radius;
    const double cosine = dot(normal, direction);
    return radius * std::sqrt(std::max(0.0, 1 - cosine * cosine));
  }
};

/// What is bounded: points, circles and spheres.
std::vector<Place> bounded_places(const Wireframe& figure) {
  std::vector<Place> places;
  for (const Numbers& point : figure.points) places.push_back({point});
  for (const WireObject& object : figure.objects) {
    if (is_unbounded(object.sort)) continue;
    const ObjectParts<double> parts = parts_of(object.sort, figure.universe(), object.place);
    places.push_back({parts.position, *parts.radius, parts.direction});
  }
  return places;
}

Numbers axis_direction(std::size_t axis, std::size_t count) {
  Numbers direction(count, 0.0);
  direction[axis] = 1;
  return direction;
}

class RoomBuilder {
 public:
  explicit RoomBuilder(std::size_t axes)
      : room_{Numbers(axes, std::numeric_limits<double>::infinity()),
              Numbers(axes, -std::numeric_limits<double>::infinity())} {}

  void add(const Place& place) {
    for (std::size_t axis = 0; axis < room_.low.size(); ++axis) {
      const double reach = place.reach(axis_direction(axis, room_.low.size()));
      room_.low[axis] = std::min(room_.low[axis], place.centre[axis] - reach);
      room_.high[axis] = std::max(room_.high[axis], place.centre[axis] + reach);
    }
  }
  bool is_empty() const { return room_.low.front() > room_.high.front(); }
  const Room& room() const { return room_; }

 private:
  Room room_;
};

/// The rectangle of a plane over which the figure lies.
std::vector<Numbers> plane_corners(const WireObject& plane, const Wireframe& figure, const Room& room) {
  constexpr double kLeast = 0.3;  // of the room, on each side of the middle
  const ObjectParts<double> parts = parts_of(Sort::plane, Universe::space, plane.place);
  const std::pair<Numbers, Numbers> axes = axes_across(parts.direction);
  const Numbers origin = foot_on(plane, Universe::space, room.centre());
  Numbers low = {-kLeast * room.size(), -kLeast * room.size()}, high = {-low[0], -low[1]};
  for (const Place& place : bounded_places(figure)) {
    const Numbers offset = difference(place.centre, origin);
    for (const auto& [axis, k] : {std::pair(&axes.first, 0U), std::pair(&axes.second, 1U)}) {
      const double at = dot(offset, *axis), reach = place.reach(*axis) + kMargin * room.size();
      low[k] = std::min(low[k], at - reach);
      high[k] = std::max(high[k], at + reach);
    }
  }
  const auto corner = [&](double x, double y) { return along(along(origin, x, axes.first), y, axes.second); };
  return {corner(low[0], low[1]), corner(high[0], low[1]), corner(high[0], high[1]), corner(low[0], high[1]),
          corner(low[0], low[1])};
}

std::vector<Numbers> circle_outline(const WireObject& circle, Universe universe) {
  const ObjectParts<double> parts = parts_of(Sort::circle, universe, circle.place);
  const std::pair<Numbers, Numbers> in_plane = {{1, 0}, {0, 1}};
  return circle_points(parts.position, universe == Universe::plane ? in_plane : axes_across(parts.direction),
                       *parts.radius);
}

}  // namespace

Numbers along(Numbers a, double factor, const Numbers& b) {
  for (std::size_t i = 0; i < a.size(); ++i) a[i] += factor * b[i];
  return a;
}

Numbers Room::centre() const {
  Numbers result;
  for (std::size_t i = 0; i < low.size(); ++i) result.push_back((low[i] + high[i]) / 2);
  return result;
}

double Room::size() const {
  double longest = 0;
  for (std::size_t i = 0; i < low.size(); ++i) longest = std::max(longest, high[i] - low[i]);
  return longest;
}

Room room_of(const Wireframe& figure) {
  const Universe universe = figure.universe();
  RoomBuilder builder(dimension(universe));
  for (const Place& place : bounded_places(figure)) builder.add(place);
  const Numbers origin(dimension(universe), 0.0);
  const Numbers middle = builder.is_empty() ? origin : builder.room().centre();
  for (const WireObject& object : figure.objects) {
    if (is_unbounded(object.sort)) builder.add({foot_on(object, universe, middle)});
  }
  for (const WireMeasure& measure : figure.measures) {
    if (measure.kind != "distance") continue;
    const WireObject& object = figure.objects[measure.objects[1] - figure.names.size()];
    builder.add({foot_on(object, universe, figure.points[measure.objects[0]])});
  }
  if (builder.is_empty()) builder.add({origin});
  Room room = builder.room();
  const double margin = room.size() > 0 ? kMargin * room.size() : 1;
  for (double& x : room.low) x -= margin;
  for (double& x : room.high) x += margin;
  return room;
}

std::optional<std::pair<Numbers, Numbers>> clipped_line(const Numbers& point, const Numbers& direction,
                                                        const Room& room) {
  double from = -std::numeric_limits<double>::infinity(), to = -from;
  for (std::size_t i = 0; i < point.size(); ++i) {
    if (direction[i] == 0) {
      if (point[i] < room.low[i] || point[i] > room.high[i]) return std::nullopt;
      continue;
    }
    const double one = (room.low[i] - point[i]) / direction[i];
    const double other = (room.high[i] - point[i]) / direction[i];
    from = std::max(from, std::min(one, other));
    to = std::min(to, std::max(one, other));
  }
  if (!(from < to)) return std::nullopt;
  return std::pair(along(point, from, direction), along(point, to, direction));
}

std::vector<Numbers> outline_of(const WireObject& object, const Wireframe& figure, const Room& room) {
  const Universe universe = figure.universe();
  switch (object.sort) {
    case Sort::line: {
      const auto ends = clipped_line(point_of(object, universe), direction_of_line(object, universe), room);
      return ends ? std::vector{ends->first, ends->second} : std::vector<Numbers>();
    }
    case Sort::plane:
      return plane_corners(object, figure, room);
    case Sort::circle:
      return circle_outline(object, universe);
    case Sort::point:
    case Sort::sphere:
      return {};
  }
  return {};
}

std::vector<Numbers> circle_points(const Numbers& centre, const std::pair<Numbers, Numbers>& axes,
                                   double radius) {
  constexpr int kParts = 96;
  std::vector<Numbers> result;
  for (int k = 0; k < kParts; ++k) {
    const double angle = 2 * std::numbers::pi * k / kParts;
    result.push_back(
        along(along(centre, radius * std::cos(angle), axes.first), radius * std::sin(angle), axes.second));
  }
  result.push_back(result.front());
  return result;
}

std::pair<Numbers, Numbers> axes_across(const Numbers& direction) {
  Numbers across = next_axis({-direction[1], direction[0], 0}, {}, 0);
  if (across.empty()) across = {1, 0, 0};
  return {across, cross(direction, across)};
}

Numbers point_of(const WireObject& object, Universe universe) {
  const ObjectParts<double> parts = parts_of(object.sort, universe, object.place);
  if (!parts.offset) return parts.position;
  return along(Numbers(parts.direction.size(), 0.0), *parts.offset, parts.direction);
}

Numbers direction_of_line(const WireObject& line, Universe universe) {
  const ObjectParts<double> parts = parts_of(Sort::line, universe, line.place);
  if (universe == Universe::space) return parts.direction;
  return {-parts.direction[1], parts.direction[0]};
}

Numbers foot_on(const WireObject& object, Universe universe, const Numbers& point) {
  const ObjectParts<double> parts = parts_of(object.sort, universe, object.place);
  const double across = dot(parts.direction, point);
  if (parts.offset) return along(point, *parts.offset - across, parts.direction);
  return along(parts.position, dot(parts.direction, difference(point, parts.position)), parts.direction);
}

}  // namespace gcslab
