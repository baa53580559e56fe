#include "experiments/tasks/space_view.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gcslab {
namespace {

constexpr double kRadians = std::numbers::pi / 180;
constexpr double kRaised = 22 * kRadians;  // above the ground

SpacePoint double_point(const ExactPolytope::Point& point) {
  return {point[0].get_d(), point[1].get_d(), point[2].get_d()};
}

}  // namespace

RationalPoint SpaceView::seen(const SpacePoint& point) const {
  std::array<double, 3> t{};
  for (std::size_t i = 0; i < 3; ++i) t[i] = (point[i] - lower[i]) / (upper[i] - lower[i]);
  const double across = std::cos(turned * kRadians) * t[0] + std::sin(turned * kRadians) * t[1];
  const double away = -std::sin(turned * kRadians) * t[0] + std::cos(turned * kRadians) * t[1];
  return {Rational(across), Rational(std::cos(kRaised) * t[2] + std::sin(kRaised) * away)};
}

ControlPolygon SpaceView::seen(const std::vector<SpacePoint>& points) const {
  ControlPolygon result;
  for (const SpacePoint& point : points) result.push_back(seen(point));
  return result;
}

bool SpaceView::faces_reader(const SpacePoint& outward) const {
  std::array<double, 3> n{};
  for (std::size_t i = 0; i < 3; ++i) n[i] = outward[i] * (upper[i] - lower[i]);
  const double away = -std::sin(turned * kRadians) * n[0] + std::cos(turned * kRadians) * n[1];
  return -std::cos(kRaised) * away + std::sin(kRaised) * n[2] > 1e-12;
}

Json space_panel(const std::string& title, Json shapes) {
  constexpr double kRoom = 0.06;
  std::array<std::array<double, 2>, 2> limits = {{{1e300, -1e300}, {1e300, -1e300}}};
  for (const Json& item : shapes) {
    for (const Json& point : item["points"]) {
      for (std::size_t k = 0; k < 2; ++k) {
        limits[k][0] = std::min(limits[k][0], point[k].get<double>() - kRoom);
        limits[k][1] = std::max(limits[k][1], point[k].get<double>() + kRoom);
      }
    }
  }
  return {{"title", title}, {"aspect", "equal"}, {"frame", false},
          {"x", limits[0]}, {"y", limits[1]},    {"shapes", std::move(shapes)}};
}

void add_axes(Json& shapes, const SpaceView& view, const std::array<std::string, 3>& names) {
  constexpr double kLonger = 1.12;
  for (std::size_t i = 0; i < 3; ++i) {
    SpacePoint end = view.lower, name = view.lower;
    end[i] += kLonger * (view.upper[i] - view.lower[i]);
    name[i] += (kLonger + 0.07) * (view.upper[i] - view.lower[i]);
    shapes.push_back(shape("segment", "axis", points_json({view.seen(view.lower), view.seen(end)})));
    shapes.push_back(label("axis", view.seen(name), names[i], "centre"));
  }
}

void add_polytope(Json& shapes, Json& front, const SpaceView& view, const ExactPolytope& polytope) {
  std::vector<SpacePoint> vertices;
  for (const auto& vertex : polytope.vertices()) vertices.push_back(double_point(vertex));
  shapes.push_back(shape("polygon", "body", points_json(convex_hull(view.seen(vertices)))));
  for (const auto& [a, b] : polytope.edges()) {
    const auto shows_edge = [&, first = a, second = b](const ExactPolytope::Facet& facet) {
      SpacePoint outward = double_point(polytope.half_spaces()[facet.half_space].normal);
      for (double& coordinate : outward) coordinate = -coordinate;
      return std::ranges::count(facet.vertices, first) + std::ranges::count(facet.vertices, second) == 2 &&
             view.faces_reader(outward);
    };
    const bool is_seen = std::ranges::any_of(polytope.facets(), shows_edge);
    Json edge = shape("segment", is_seen ? "edge" : "hidden",
                      points_json({view.seen(vertices[a]), view.seen(vertices[b])}));
    (is_seen ? front : shapes).push_back(std::move(edge));
  }
}

}  // namespace gcslab
