#include "experiments/tasks/illustration.h"

#include <algorithm>

namespace gcslab {

Json point_json(const RationalPoint& p) { return {p[0].get_d(), p[1].get_d()}; }

Json points_json(const ControlPolygon& points) {
  Json list = Json::array();
  for (const RationalPoint& p : points) list.push_back(point_json(p));
  return list;
}

Json shape(const char* kind, const char* style, Json points, const std::string& text) {
  Json result = {{"kind", kind}, {"style", style}, {"points", std::move(points)}};
  if (!text.empty()) result["text"] = text;
  return result;
}

Json label(const char* style, const RationalPoint& place, const std::string& text, const char* anchor) {
  Json result = shape("label", style, Json::array({point_json(place)}), text);
  result["anchor"] = anchor;
  return result;
}

ControlPolygon convex_hull(ControlPolygon points) {
  std::ranges::sort(points);
  if (points.size() < 3) return points;
  const auto turn = [](const RationalPoint& a, const RationalPoint& b, const RationalPoint& c) {
    return Rational((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]));
  };
  ControlPolygon hull;
  for (int pass = 0; pass < 2; ++pass) {
    const std::size_t start = hull.size();
    for (const RationalPoint& p : points) {
      while (hull.size() >= start + 2 && turn(hull[hull.size() - 2], hull.back(), p) <= 0) hull.pop_back();
      hull.push_back(p);
    }
    hull.pop_back();
    std::ranges::reverse(points);
  }
  return hull;
}

Json limits_around(const ControlPolygon& points, std::size_t axis, double margin) {
  const auto [least, greatest] =
      std::ranges::minmax(points, {}, [axis](const RationalPoint& p) { return p[axis]; });
  const double low = least[axis].get_d(), high = greatest[axis].get_d();
  const double room = margin * (high - low);
  return {low - room, high + room};
}

}  // namespace gcslab
