#include "geometry/constraint_kind.h"

namespace gcslab {

std::vector<ConstraintKind> collinear_constraints() {
  ConstraintKind kind;
  kind.name = "collinear";
  kind.summary = "three points lie on a line";
  kind.universes = {Universe::plane, Universe::space};
  kind.sorts = std::vector(3, Sort::point);
  kind.restriction = [](Universe universe) { return universe == Universe::plane ? 1 : 2; };
  kind.auxiliaries = &auxiliaries_of_multiple;
  kind.metric_form = "area";
  kind.interpretations = {{"line", "det(PQ, PR) = 0 in the plane; PR = s PQ in space, with an unknown s",
                           [](const ConstraintPlace& place, const std::optional<Expression>&) {
                             return multiple_equations(place, place.vector(0, 1), place.vector(0, 2));
                           }}};
  return {kind};
}

}  // namespace gcslab
