#include "experiments/reporting/seen_measures.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "experiments/reporting/object_outline.h"

namespace gcslab {
namespace {

/// Three places of the figure: the corner of an angle and a point on each arm.
struct Arms {
  Numbers at, from, to;
};

class MeasureBuilder {
 public:
  MeasureBuilder(const Wireframe& figure, const View& view)
      : figure_(figure), view_(view), universe_(figure.universe()), room_(room_of(figure)) {}

  std::optional<SeenMeasure> seen(const WireMeasure& measure) const {
    if (measure.kind == "distance") return distance(measure);
    if (measure.kind == "radius") return radius(measure);
    if (measure.kind == "angle") return angle(measure);
    if (measure.kind == "area") return area(measure);
    if (measure.kind == "volume") return volume(measure);
    return std::nullopt;
  }

 private:
  const WireObject& object(std::size_t number) const {
    return figure_.objects[number - figure_.names.size()];
  }
  std::array<SeenPoint, 2> guide(const Numbers& from, const Numbers& to) const {
    return {view_.seen(from), view_.seen(to)};
  }

  std::optional<SeenMeasure> distance(const WireMeasure& measure) const {
    const Numbers& point = figure_.points[measure.objects[0]];
    const Numbers foot = foot_on(object(measure.objects[1]), universe_, point);
    const Numbers offset = difference(foot, point);
    if (dot(offset, offset) == 0) return std::nullopt;
    return SeenMeasure{.label = measure.label, .guides = {guide(point, foot)}};
  }

  // ---- radii ----

  std::optional<SeenMeasure> radius(const WireMeasure& measure) const {
    const WireObject& round = object(measure.objects[0]);
    const ObjectParts<double> parts = parts_of(round.sort, universe_, round.place);
    const SeenPoint centre = view_.seen(parts.position);
    std::vector<SeenPoint> rim;
    for (const SeenObject& seen : seen_objects(figure_, view_)) {
      if (&figure_.objects[seen.number] == &round) rim = seen.outline;
    }
    if (*parts.radius == 0 || rim.empty()) return std::nullopt;
    return SeenMeasure{.label = measure.label, .guides = {{centre, freest(centre, rim, round)}}};
  }

  /// The point of the rim that the line from the centre reaches farthest from everything else.
  SeenPoint freest(const SeenPoint& centre, const std::vector<SeenPoint>& rim,
                   const WireObject& round) const {
    constexpr std::size_t kStep = 4;
    const std::vector<std::array<SeenPoint, 2>> others = lines_but(round);
    SeenPoint best = rim.front();
    double farthest = -1;
    for (std::size_t k = 0; k < rim.size(); k += kStep) {
      const SeenPoint middle = {(centre.x + rim[k].x) / 2, (centre.y + rim[k].y) / 2};
      double least = std::numeric_limits<double>::infinity();
      for (const auto& [a, b] : others) least = std::min(least, distance_to_segment(middle, a, b));
      if (least <= farthest) continue;
      farthest = least;
      best = rim[k];
    }
    return best;
  }

  /// Edges and outlines without that of one object.
  std::vector<std::array<SeenPoint, 2>> lines_but(const WireObject& left_out) const {
    std::vector<std::array<SeenPoint, 2>> lines;
    for (const WireEdge& edge : figure_.edges)
      lines.push_back(guide(figure_.points[edge.from], figure_.points[edge.to]));
    for (const SeenObject& seen : seen_objects(figure_, view_)) {
      if (&figure_.objects[seen.number] == &left_out) continue;
      for (std::size_t k = 1; k < seen.outline.size(); ++k)
        lines.push_back({seen.outline[k - 1], seen.outline[k]});
    }
    return lines;
  }

  // ---- angles ----

  std::optional<SeenMeasure> angle(const WireMeasure& measure) const {
    const WireObject &one = object(measure.objects[0]), &other = object(measure.objects[1]);
    const bool are_drawn = universe_ == Universe::plane;
    std::optional<Arms> arms;
    if (universe_ == Universe::plane) {
      arms = between_lines_of_the_plane(one, other);
    } else if (one.sort == Sort::line && other.sort == Sort::line) {
      arms = between_lines_of_space(one, other);
    } else if (one.sort == Sort::line) {
      arms = between_line_and_plane(one, other);
    } else {
      arms = between_planes(one, other);
    }
    if (!arms || !is_in_room(arms->at)) return std::nullopt;
    SeenMeasure seen{.label = measure.label};
    seen.angle = SeenAngle{view_.seen(arms->at), view_.seen(arms->from), view_.seen(arms->to)};
    if (!are_drawn) seen.guides = {guide(arms->at, arms->from), guide(arms->at, arms->to)};
    return seen;
  }

  bool is_in_room(const Numbers& point) const {
    for (std::size_t i = 0; i < point.size(); ++i) {
      if (!(room_.low[i] <= point[i] && point[i] <= room_.high[i])) return false;
    }
    return true;
  }

  /// From a point along two directions, the first towards the middle of the room, at most a right angle
  /// apart.
  Arms arms_along(const Numbers& at, const Numbers& first, const Numbers& second) const {
    constexpr double kLength = 0.25;  // of the room
    const double length = kLength * room_.size();
    const double way = dot(difference(room_.centre(), at), first) < 0 ? -length : length;
    const double other_way = dot(first, second) < 0 ? -way : way;
    return {at, along(at, way, first), along(at, other_way, second)};
  }

  std::optional<Arms> between_lines_of_the_plane(const WireObject& one, const WireObject& other) const {
    const Numbers p = point_of(one, universe_), u = direction_of_line(one, universe_);
    const Numbers q = point_of(other, universe_), v = direction_of_line(other, universe_);
    const double determinant = u[0] * v[1] - u[1] * v[0];
    if (determinant == 0) return std::nullopt;
    const Numbers w = difference(q, p);
    return arms_along(along(p, (w[0] * v[1] - w[1] * v[0]) / determinant, u), u, v);
  }

  /// At the point of the first line that is nearest to the second, which is moved there.
  std::optional<Arms> between_lines_of_space(const WireObject& one, const WireObject& other) const {
    const Numbers p = point_of(one, universe_), u = direction_of_line(one, universe_);
    const Numbers q = point_of(other, universe_), v = direction_of_line(other, universe_);
    const double cosine = dot(u, v), squared_sine = 1 - cosine * cosine;
    if (!(squared_sine > 0)) return std::nullopt;
    const Numbers w = difference(q, p);
    return arms_along(along(p, (dot(w, u) - cosine * dot(w, v)) / squared_sine, u), u, v);
  }

  /// Where they meet; the second arm is the projection of the line.
  std::optional<Arms> between_line_and_plane(const WireObject& line, const WireObject& plane) const {
    const Numbers p = point_of(line, universe_), u = direction_of_line(line, universe_);
    const ObjectParts<double> parts = parts_of(Sort::plane, universe_, plane.place);
    const double sine = dot(u, parts.direction);
    const Numbers shadow = next_axis(u, {parts.direction}, 0);
    if (sine == 0 || shadow.empty()) return std::nullopt;
    return arms_along(along(p, (*parts.offset - dot(parts.direction, p)) / sine, u), u, shadow);
  }

  /// At right angles to the common line, at its point nearest to the middle of the room.
  std::optional<Arms> between_planes(const WireObject& one, const WireObject& other) const {
    const ObjectParts<double> first = parts_of(Sort::plane, universe_, one.place);
    const ObjectParts<double> second = parts_of(Sort::plane, universe_, other.place);
    const double cosine = dot(first.direction, second.direction);
    const Numbers u = next_axis(second.direction, {first.direction}, 1e-9);  // in the first plane
    const Numbers v = next_axis(first.direction, {second.direction}, 1e-9);
    if (u.empty() || v.empty()) return std::nullopt;
    const Numbers middle = foot_on(one, universe_, room_.centre());
    const double to_second = *second.offset - dot(second.direction, middle);
    return arms_along(along(middle, to_second / std::sqrt(1 - cosine * cosine), u), u, v);
  }

  // ---- areas and volumes ----

  std::optional<SeenMeasure> area(const WireMeasure& measure) const {
    SeenMeasure seen{.label = measure.label};
    Numbers middle(dimension(universe_), 0.0);
    for (std::size_t k = 0; k < 3; ++k) {
      const Numbers& point = figure_.points[measure.objects[k]];
      seen.guides.push_back(guide(point, figure_.points[measure.objects[(k + 1) % 3]]));
      middle = along(middle, 1.0 / 3, point);
    }
    seen.middle = view_.seen(middle);
    return seen;
  }

  /// The parallelepiped that three edges of the tetrahedron span, of which it is a sixth.
  std::optional<SeenMeasure> volume(const WireMeasure& measure) const {
    const Numbers& origin = figure_.points[measure.objects[0]];
    std::array<Numbers, 3> edges;
    for (std::size_t k = 0; k < 3; ++k) edges[k] = difference(figure_.points[measure.objects[k + 1]], origin);
    const auto corner = [&](std::size_t which) {
      Numbers result = origin;
      for (std::size_t k = 0; k < 3; ++k) {
        if ((which >> k & 1U) != 0) result = along(result, 1, edges[k]);
      }
      return result;
    };
    SeenMeasure seen{.label = measure.label};
    for (std::size_t from = 0; from < 8; ++from) {
      for (std::size_t k = 0; k < 3; ++k) {
        if ((from >> k & 1U) == 0) seen.guides.push_back(guide(corner(from), corner(from | 1U << k)));
      }
    }
    Numbers middle = origin;
    for (const Numbers& edge : edges) middle = along(middle, 0.5, edge);
    seen.middle = view_.seen(middle);
    return seen;
  }

  const Wireframe& figure_;
  const View& view_;
  Universe universe_;
  Room room_;
};

}  // namespace

std::vector<SeenMeasure> seen_measures(const Wireframe& figure, const View& view) {
  std::vector<SeenMeasure> result;
  if (figure.measures.empty()) return result;
  const MeasureBuilder builder(figure, view);
  for (const WireMeasure& measure : figure.measures) {
    if (std::optional<SeenMeasure> seen = builder.seen(measure)) result.push_back(std::move(*seen));
  }
  return result;
}

}  // namespace gcslab
