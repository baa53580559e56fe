#include "geometry/constraint_kind.h"

namespace gcslab {

ConstraintKind perpendicular_constraint() {
  ConstraintKind kind;
  kind.name = "perpendicular";
  kind.summary = "the directions PQ and RS are perpendicular";
  kind.universes = {Universe::plane, Universe::space};
  kind.points = 4;
  kind.is_about_pairs = true;
  kind.restriction = [](Universe) { return 1; };
  kind.interpretations = {
      {"product", "PQ.RS = 0", [](const ConstraintPlace& place, const std::optional<Expression>&) {
         const Vector u = place.vector(0, 1), v = place.vector(2, 3);
         return std::vector{dot(u, v)};
       }}};
  return kind;
}

}  // namespace gcslab
