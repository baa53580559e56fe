#include "geometry/constraint_kind.h"

namespace gcslab {

ConstraintKind parallel_constraint() {
  ConstraintKind kind;
  kind.name = "parallel";
  kind.summary = "the lines PQ and RS are parallel";
  kind.universes = {Universe::plane, Universe::space};
  kind.points = 4;
  kind.is_about_pairs = true;
  kind.restriction = [](Universe universe) { return universe == Universe::plane ? 1 : 2; };
  kind.auxiliaries = &auxiliaries_of_multiple;
  kind.interpretations = {{"multiple", "det(PQ, RS) = 0 in the plane; RS = s PQ in space, with an unknown s",
                           [](const ConstraintPlace& place, const std::optional<Expression>&) {
                             return multiple_equations(place, place.vector(0, 1), place.vector(2, 3));
                           }}};
  return kind;
}

}  // namespace gcslab
