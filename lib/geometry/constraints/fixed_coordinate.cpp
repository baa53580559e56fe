#include "geometry/constraint_kind.h"

namespace gcslab {

std::vector<ConstraintKind> fixed_coordinate_constraints(std::size_t axis) {
  const std::string letter(1, "xyz"[axis]);
  ConstraintKind kind;
  kind.name = "fixed_" + letter;
  kind.summary = "the " + letter + " coordinate of a point";
  kind.universes = {Universe::space};
  if (axis < 2) kind.universes.push_back(Universe::plane);
  kind.sorts = std::vector(1, Sort::point);
  kind.measure = [axis](const ConstraintPlace& place) { return place.objects[0].position[axis]; };
  kind.interpretations = {{"coordinate", letter + " = a",
                           [axis](const ConstraintPlace& place, const std::optional<Expression>& a) {
                             return std::vector{place.objects[0].position[axis] - *a};
                           }}};
  return {kind};
}

}  // namespace gcslab
