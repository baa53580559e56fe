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
  kind.auxiliaries = [](Universe universe) { return std::size_t{universe == Universe::plane ? 0U : 1U}; };
  kind.interpretations = {{"multiple", "det(PQ, RS) = 0 in the plane; RS = s PQ in space, with an unknown s",
                           [](const ConstraintPlace& place, const std::optional<Expression>&) {
                             const Vector u = place.vector(0, 1), v = place.vector(2, 3);
                             if (place.universe == Universe::plane) return std::vector{determinant(u, v)};
                             std::vector<Expression> equations;
                             for (std::size_t i = 0; i < v.size(); ++i)
                               equations.push_back(v[i] - place.auxiliaries[0] * u[i]);
                             return equations;
                           }}};
  return kind;
}

}  // namespace gcslab
