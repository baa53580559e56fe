#include "geometry/constraint_kind.h"

namespace gcslab {

std::vector<ConstraintKind> equal_lengths_constraints() {
  ConstraintKind kind;
  kind.name = "equal_lengths";
  kind.summary = "the segments PQ and RS have the same length";
  kind.universes = {Universe::plane, Universe::space};
  kind.sorts = std::vector(4, Sort::point);
  kind.is_about_pairs = true;
  kind.interpretations = {
      {"squared", "|PQ|^2 = |RS|^2", [](const ConstraintPlace& place, const std::optional<Expression>&) {
         const Vector u = place.vector(0, 1), v = place.vector(2, 3);
         return std::vector{squared_norm(u) - squared_norm(v)};
       }}};
  return {kind};
}

}  // namespace gcslab
