#include "geometry/constraint_kind.h"

namespace gcslab {

ConstraintKind fixed_coordinate_constraint(std::size_t axis) {
  const std::string letter(1, "xyz"[axis]);
  ConstraintKind kind;
  kind.name = "fixed_" + letter;
  kind.summary = "the " + letter + " coordinate of a point";
  kind.universes = {Universe::space};
  if (axis < 2) kind.universes.push_back(Universe::plane);
  kind.points = 1;
  kind.restriction = [](Universe) { return 1; };
  kind.measure = [axis](const ConstraintPlace& place) { return place.points[0][axis]; };
  kind.interpretations = {{"coordinate", letter + " = a",
                           [axis](const ConstraintPlace& place, const std::optional<Expression>& a) {
                             return std::vector{place.points[0][axis] - *a};
                           }}};
  return kind;
}

}  // namespace gcslab
