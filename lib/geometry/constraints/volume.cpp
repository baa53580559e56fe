#include "geometry/constraint_kind.h"

namespace gcslab {

std::vector<ConstraintKind> volume_constraints() {
  ConstraintKind kind;
  kind.name = "volume";
  kind.summary = "the signed volume of a tetrahedron";
  kind.universes = {Universe::space};
  kind.sorts = std::vector(4, Sort::point);
  kind.measure = [](const ConstraintPlace& place) {
    const Expression volume = determinant(place.vector(0, 1), place.vector(0, 2), place.vector(0, 3));
    return volume / volume.graph().constant(6);
  };
  kind.interpretations = {{"polynomial", "det(PQ, PR, PS) = 6 v",
                           [](const ConstraintPlace& place, const std::optional<Expression>& v) {
                             return std::vector{
                                 determinant(place.vector(0, 1), place.vector(0, 2), place.vector(0, 3)) -
                                 v->graph().constant(6) * *v};
                           }}};
  return {kind};
}

}  // namespace gcslab
