#include "packing/circle_layout.h"

#include <deque>
#include <set>

namespace gcslab {
namespace {

MpfrInterval number(const Rational& value) { return NumberTraits<MpfrInterval>::from_rational(value); }

class Layout {
 public:
  Layout(const Triangulation& graph, const std::vector<MpfrInterval>& radii)
      : graph_(graph), discs_(radii.size()), is_placed_(radii.size(), false) {
    for (std::size_t v = 0; v < radii.size(); ++v) discs_[v].radius = radii[v];
  }

  std::vector<EnclosedDisc> run(const OuterDiscs& outer) {
    for (std::size_t v = 0; v < 3; ++v) {
      discs_[v] = {number(outer[v].x), number(outer[v].y), number(outer[v].radius)};
      is_placed_[v] = true;
    }
    for (const auto& [u, v] : {Edge{0, 1}, Edge{1, 2}, Edge{2, 0}}) open_.emplace_back(u, v);
    while (!open_.empty()) {
      const auto [u, v] = open_.front();
      open_.pop_front();
      take_left_of(u, v);
    }
    return std::move(discs_);
  }

 private:
  /// Takes the face on the left of an edge, unless it was taken from another one.
  void take_left_of(int u, int v) {
    if (taken_.contains({u, v})) return;
    const int w = graph_.left_of(u, v);
    taken_.insert({{u, v}, {v, w}, {w, u}});
    const auto place = static_cast<std::size_t>(w);
    if (!is_placed_[place])
      put(discs_[static_cast<std::size_t>(u)], discs_[static_cast<std::size_t>(v)], discs_[place]);
    is_placed_[place] = true;
    for (const auto& [a, b] : {Edge{u, w}, Edge{w, v}}) {
      if (!is_outer({a, b})) open_.emplace_back(a, b);
    }
  }

  void put(const EnclosedDisc& u, const EnclosedDisc& v, EnclosedDisc& w) const {
    const MpfrInterval distance = u.radius + v.radius;
    const MpfrInterval along = (u.radius + w.radius - two_ * v.radius * w.radius / distance) / distance;
    const MpfrInterval whole = distance + w.radius;
    const MpfrInterval across = two_ * sqrt(u.radius * v.radius * w.radius * whole) / sqr(distance);
    const MpfrInterval dx = v.x - u.x, dy = v.y - u.y;
    w.x = u.x + along * dx - across * dy;
    w.y = u.y + along * dy + across * dx;
  }

  const Triangulation& graph_;
  MpfrInterval two_ = number(2);
  std::vector<EnclosedDisc> discs_;
  std::vector<bool> is_placed_;
  std::set<std::pair<int, int>> taken_;  ///< edges, each from its face on the left
  std::deque<std::pair<int, int>> open_;
};

}  // namespace

std::vector<EnclosedDisc> lay_out(const Triangulation& graph, const OuterDiscs& outer,
                                  const std::vector<MpfrInterval>& radii) {
  return Layout(graph, radii).run(outer);
}

}  // namespace gcslab
