#include "geometry/constraint_kind.h"

namespace gcslab {

std::vector<ConstraintKind> coplanar_constraints() {
  ConstraintKind kind;
  kind.name = "coplanar";
  kind.summary = "four points lie in a plane";
  kind.universes = {Universe::space};
  kind.sorts = std::vector(4, Sort::point);
  kind.metric_form = "volume";
  kind.interpretations = {{"determinant", "det(PQ, PR, PS) = 0",
                           [](const ConstraintPlace& place, const std::optional<Expression>&) {
                             return std::vector{
                                 determinant(place.vector(0, 1), place.vector(0, 2), place.vector(0, 3))};
                           }}};
  return {kind};
}

}  // namespace gcslab
