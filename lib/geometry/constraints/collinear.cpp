#include "geometry/constraint_kind.h"

namespace gcslab {

ConstraintKind collinear_constraint() {
  ConstraintKind kind;
  kind.name = "collinear";
  kind.summary = "three points lie on a line";
  kind.universes = {Universe::plane, Universe::space};
  kind.points = 3;
  kind.restriction = [](Universe universe) { return universe == Universe::plane ? 1 : 2; };
  kind.auxiliaries = [](Universe universe) { return std::size_t{universe == Universe::plane ? 0U : 1U}; };
  kind.metric_form = "area";
  kind.interpretations = {{"line", "det(PQ, PR) = 0 in the plane; PR = s PQ in space, with an unknown s",
                           [](const ConstraintPlace& place, const std::optional<Expression>&) {
                             const Vector u = place.vector(0, 1);
                             const Vector v = place.vector(0, 2);
                             if (place.universe == Universe::plane) return std::vector{determinant(u, v)};
                             std::vector<Expression> equations;
                             for (std::size_t i = 0; i < v.size(); ++i)
                               equations.push_back(v[i] - place.auxiliaries[0] * u[i]);
                             return equations;
                           }}};
  return kind;
}

}  // namespace gcslab
