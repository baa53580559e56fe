#include "geometry/constraint_kind.h"

namespace gcslab {
namespace {

Expression half(Expression e) { return e / e.graph().constant(2); }

/// Twice the area: signed in the plane, squared in space.
Expression doubled(const ConstraintPlace& place) {
  const Vector u = place.vector(0, 1), v = place.vector(0, 2);
  return place.universe == Universe::plane ? determinant(u, v) : squared_norm(cross(u, v));
}

}  // namespace

std::vector<ConstraintKind> area_constraints() {
  ConstraintKind kind;
  kind.name = "area";
  kind.summary = "the area of a triangle; in the plane positive when its points turn left";
  kind.universes = {Universe::plane, Universe::space};
  kind.sorts = std::vector(3, Sort::point);
  kind.measure = [](const ConstraintPlace& place) {
    const Vector u = place.vector(0, 1), v = place.vector(0, 2);
    return half(place.universe == Universe::plane ? determinant(u, v) : norm(cross(u, v)));
  };
  kind.interpretations = {{"polynomial", "det(u, v) = 2 a in the plane, |u x v|^2 = 4 a^2 in space",
                           [](const ConstraintPlace& place, const std::optional<Expression>& a) {
                             const Expression twice = a->graph().constant(2) * *a;
                             return std::vector{doubled(place) -
                                                (place.universe == Universe::plane ? twice : sqr(twice))};
                           }}};
  return {kind};
}

}  // namespace gcslab
