#include "packing/packing_system.h"

#include <algorithm>

#include "base/check.h"
#include "interval/elementary.h"
#include "interval/fast_interval.h"

namespace gcslab {
namespace {

/// Centre and radius as expressions.
struct DiscTerms {
  Expression x, y, radius;
};

/// |c - c'|^2 - (r + r')^2.
Expression distance_excess(const DiscTerms& a, const DiscTerms& b) {
  return pow(a.x - b.x, 2) + pow(a.y - b.y, 2) - pow(a.radius + b.radius, 2);
}

std::vector<DiscTerms> disc_terms(ExpressionGraph& graph, const OuterDiscs& outer, int inner) {
  std::vector<DiscTerms> discs;
  for (const RationalDisc& disc : outer)
    discs.push_back({graph.constant(disc.x), graph.constant(disc.y), graph.constant(disc.radius)});
  for (int i = 0; i < inner; ++i)
    discs.push_back({graph.variable(3 * i), graph.variable(3 * i + 1), graph.variable(3 * i + 2)});
  return discs;
}

/// Where two tangent discs touch, as a part of the segment of their centres.
Rational tangency(const Rational& a, const Rational& b, const RationalDisc& first,
                  const RationalDisc& second) {
  return a + (b - a) * first.radius / (first.radius + second.radius);
}

/// The range of one coordinate over the three points of tangency.
Interval gap_side(const OuterDiscs& outer, Rational RationalDisc::*coordinate) {
  Interval side;
  for (std::size_t i = 0; i < 3; ++i) {
    const RationalDisc& a = outer[i];
    const RationalDisc& b = outer[(i + 1) % 3];
    side = hull(side, elementary::enclosing(tangency(a.*coordinate, b.*coordinate, a, b)));
  }
  return side;
}

double largest_radius(const OuterDiscs& outer) {
  const NumberTraits<FastInterval>::Scope scope;
  const Rational a = 1 / outer[0].radius, b = 1 / outer[1].radius, c = 1 / outer[2].radius;
  const auto number = [](const Rational& value) { return NumberTraits<FastInterval>::from_rational(value); };
  const FastInterval curvature = number(a + b + c) + number(2) * sqrt(number(a * b + b * c + c * a));
  return (number(1) / curvature).upper();
}

Box gap_box(const OuterDiscs& outer, int inner, const Rational& least_radius) {
  const Interval x = gap_side(outer, &RationalDisc::x);
  const Interval y = gap_side(outer, &RationalDisc::y);
  const Interval radius = {elementary::enclosing(least_radius).lower, largest_radius(outer)};
  GCSLAB_CHECK(radius.lower <= radius.upper);
  Box box;
  for (int i = 0; i < inner; ++i) box.insert(box.end(), {x, y, radius});
  return box;
}

}  // namespace

const OuterDiscs& standard_outer_discs() {
  static const OuterDiscs discs = {RationalDisc{0, 0, 1}, RationalDisc{3, 0, 2}, RationalDisc{0, 4, 3}};
  return discs;
}

bool are_mutually_tangent(const OuterDiscs& outer) {
  for (std::size_t i = 0; i < 3; ++i) {
    const RationalDisc& a = outer[i];
    const RationalDisc& b = outer[(i + 1) % 3];
    const Rational dx = a.x - b.x, dy = a.y - b.y, sum = a.radius + b.radius;
    if (a.radius <= 0 || dx * dx + dy * dy != sum * sum) return false;
  }
  return true;
}

EquationSystem packing_system(const Triangulation& graph, const OuterDiscs& outer,
                              const Rational& least_radius) {
  GCSLAB_CHECK(are_mutually_tangent(outer));
  EquationSystem system;
  const std::vector<DiscTerms> discs = disc_terms(*system.graph, outer, graph.inner_vertices());
  for (int v = 3; v < graph.vertices(); ++v) {
    for (const char* letter : {"x", "y", "r"}) system.variables.push_back(letter + std::to_string(v));
  }
  for (int u = 0; u < graph.vertices(); ++u) {
    for (int v = std::max(u + 1, 3); v < graph.vertices(); ++v) {
      const Expression excess =
          distance_excess(discs[static_cast<std::size_t>(v)], discs[static_cast<std::size_t>(u)]);
      if (graph.has_edge(u, v)) {
        system.equations.push_back(excess);
      } else {
        system.inequalities.push_back(-excess);
      }
    }
  }
  system.box = gap_box(outer, graph.inner_vertices(), least_radius);
  return system;
}

}  // namespace gcslab
