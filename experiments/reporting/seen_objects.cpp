#include "experiments/reporting/seen_objects.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "experiments/reporting/object_outline.h"

namespace gcslab {
namespace {

/// On which side of the line from a to b, seen on paper, a point is.
double side_of(const SeenPoint& a, const SeenPoint& b, const SeenPoint& p) {
  return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

bool is_within(const std::vector<SeenPoint>& convex, const SeenPoint& point) {
  bool is_left = true, is_right = true;
  for (std::size_t k = 1; k < convex.size(); ++k) {
    const double side = side_of(convex[k - 1], convex[k], point);
    is_left = is_left && side >= 0;
    is_right = is_right && side <= 0;
  }
  return is_left || is_right;
}

/// How far away the plane through three points is seen at a place on paper; infinite when it is seen edge-on.
double away_at(const SeenPoint& a, const SeenPoint& b, const SeenPoint& c, const SeenPoint& place) {
  const double whole = side_of(a, b, c);
  const double at_c = side_of(a, b, place) / whole, at_b = side_of(place, a, c) / -whole;
  return a.away + at_b * (b.away - a.away) + at_c * (c.away - a.away);
}

SeenObject seen_sphere(std::size_t number, const WireObject& object, const View& view) {
  const ObjectParts<double> parts = parts_of(Sort::sphere, Universe::space, object.place);
  SeenObject seen{number, Sort::sphere, {}};
  seen.centre = view.seen(parts.position);
  seen.radius = *parts.radius;
  for (const Numbers& p : circle_points({seen.centre.x, seen.centre.y}, {{1, 0}, {0, 1}}, seen.radius))
    seen.outline.push_back({p[0], p[1], seen.centre.away});
  constexpr int kParts = 48;
  const double start = (view.turned - 180) * std::numbers::pi / 180;
  for (int k = 0; k <= kParts; ++k) {
    const double angle = start + std::numbers::pi * k / kParts;
    const Numbers outwards = {std::cos(angle), std::sin(angle), 0};
    seen.relief.push_back(view.seen(along(parts.position, seen.radius, outwards)));
  }
  return seen;
}

/// The direction from the reader into the paper.
Numbers sight_of(const View& view) {
  Numbers sight;
  for (const Numbers& axis : {Numbers{1, 0, 0}, Numbers{0, 1, 0}, Numbers{0, 0, 1}})
    sight.push_back(view.seen(axis).away);
  return sight;
}

}  // namespace

bool SeenObject::hides(const SeenPoint& point, double slack) const {
  if (sort == Sort::sphere) {
    const double squared = radius * radius - (point.x - centre.x) * (point.x - centre.x) -
                           (point.y - centre.y) * (point.y - centre.y);
    return squared > 0 && point.away > centre.away - std::sqrt(squared) + slack;
  }
  if (sort != Sort::plane || !is_within(outline, point)) return false;
  return point.away > away_at(outline[0], outline[1], outline[2], point) + slack;
}

std::vector<std::array<SeenPoint, 2>> SeenObject::pieces_for_name() const {
  // Parts of the way along a straight piece; those of a round outline are short.
  const bool is_round = sort == Sort::circle || sort == Sort::sphere;
  const std::vector<double> cuts =
      is_round ? std::vector{0.0, 1.0} : std::vector{0.0, 0.08, 0.16, 0.84, 0.92, 1.0};
  std::vector<std::array<SeenPoint, 2>> result;
  for (std::size_t i = 1; i < outline.size(); ++i) {
    const SeenPoint &a = outline[i - 1], &b = outline[i];
    const auto at = [&](double part) {
      return SeenPoint{a.x + part * (b.x - a.x), a.y + part * (b.y - a.y), a.away + part * (b.away - a.away)};
    };
    for (std::size_t k = 1; k < cuts.size(); ++k) {
      const bool is_near_an_end = cuts[k - 1] >= 0.5 || cuts[k] <= 0.5;
      if (is_round || is_near_an_end) result.push_back({at(cuts[k - 1]), at(cuts[k])});
    }
  }
  return result;
}

std::vector<const SeenObject*> surfaces_from_the_rear(const std::vector<SeenObject>& objects) {
  std::vector<const SeenObject*> surfaces;
  for (const SeenObject& object : objects) {
    if (object.is_surface()) surfaces.push_back(&object);
  }
  const auto nearness = [](const SeenObject* object) {
    double sum = 0;
    for (const SeenPoint& p : object->outline) sum -= p.away;
    return sum / static_cast<double>(object->outline.size());
  };
  std::ranges::stable_sort(surfaces, {}, nearness);
  return surfaces;
}

bool is_hidden(const SeenPoint& point, const std::vector<SeenObject>& objects,
               const std::optional<std::size_t>& own, double slack) {
  for (std::size_t k = 0; k < objects.size(); ++k) {
    if (k != own && objects[k].is_surface() && objects[k].hides(point, slack)) return true;
  }
  return false;
}

std::vector<SeenObject> seen_objects(const Wireframe& figure, const View& view) {
  std::vector<SeenObject> result;
  if (figure.objects.empty()) return result;
  const Room room = room_of(figure);
  for (std::size_t k = 0; k < figure.objects.size(); ++k) {
    const WireObject& object = figure.objects[k];
    if (object.sort == Sort::sphere) {
      result.push_back(seen_sphere(k, object, view));
      continue;
    }
    std::vector<SeenPoint> outline = seen_points(view, outline_of(object, figure, room));
    if (!outline.empty()) result.push_back({k, object.sort, std::move(outline)});
  }
  return result;
}

double openness(const Wireframe& figure, const View& view) {
  double least = 1;
  if (figure.universe() == Universe::plane) return least;
  const Numbers sight = sight_of(view);
  for (const WireObject& object : figure.objects) {
    const ObjectParts<double> parts = parts_of(object.sort, Universe::space, object.place);
    if (parts.direction.empty()) continue;
    const double cosine = std::min(1.0, std::abs(dot(parts.direction, sight)));
    least = std::min(least, object.sort == Sort::line ? std::sqrt(1 - cosine * cosine) : cosine);
  }
  return least;
}

}  // namespace gcslab
