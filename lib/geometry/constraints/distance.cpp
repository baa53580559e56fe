#include "geometry/constraint_kind.h"

namespace gcslab {
namespace {

using Length = std::function<Expression(const ConstraintPlace&)>;

/// A length is h, or its square is h^2.
ConstraintKind kind_of(Sort second, const std::string& summary, const std::vector<Universe>& universes,
                       const Length& length, const Length& square, const std::string& formula) {
  ConstraintKind kind;
  kind.name = "distance";
  kind.summary = summary;
  kind.universes = universes;
  kind.sorts = {Sort::point, second};
  kind.measure = length;
  kind.possible = kAnyLength;
  kind.nearness = Nearness::parameter;
  kind.interpretations = {{"squared", formula + "^2 = h^2, a polynomial",
                           [square](const ConstraintPlace& place, const std::optional<Expression>& h) {
                             return std::vector{square(place) - sqr(*h)};
                           }},
                          {"norm", formula + " = h, not smooth where it is 0",
                           [length](const ConstraintPlace& place, const std::optional<Expression>& h) {
                             return std::vector{length(place) - *h};
                           },
                           [square](const ConstraintPlace& place) { return std::vector{square(place)}; }}};
  return kind;
}

Expression absolute(Expression e) { return e.graph().apply(Operation::abs, e); }

/// n.P - d, whose sign is that of the normal.
Expression height(const ConstraintPlace& place) {
  const auto& [point, object] = std::tie(place.objects[0], place.objects[1]);
  return dot(object.direction, point.position) - *object.offset;
}

/// (P - m) x u.
Vector moment(const ConstraintPlace& place) { return cross(place.vector(1, 0), place.objects[1].direction); }

bool is_by_height(const ConstraintPlace& place) { return place.objects[1].offset.has_value(); }

Expression height_or_moment(const ConstraintPlace& place) {
  return is_by_height(place) ? absolute(height(place)) : norm(moment(place));
}

Expression its_square(const ConstraintPlace& place) {
  return is_by_height(place) ? sqr(height(place)) : squared_norm(moment(place));
}

}  // namespace

std::vector<ConstraintKind> distance_constraints() {
  const std::vector<Universe> both = {Universe::plane, Universe::space};
  return {kind_of(
              Sort::point, "the distance of two points", both,
              [](const ConstraintPlace& place) { return norm(place.vector(0, 1)); },
              [](const ConstraintPlace& place) { return squared_norm(place.vector(0, 1)); }, "|PQ|"),
          kind_of(Sort::line, "the distance of a point from a line, without sign", both, height_or_moment,
                  its_square, "|n.P - d| in the plane, |(P - m) x u| in space,"),
          kind_of(Sort::plane, "the distance of a point from a plane, without sign", {Universe::space},
                  height_or_moment, its_square, "|n.P - d|")};
}

}  // namespace gcslab
