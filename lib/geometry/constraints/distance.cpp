#include <limits>

#include "geometry/constraint_kind.h"

namespace gcslab {

ConstraintKind distance_constraint() {
  ConstraintKind kind;
  kind.name = "distance";
  kind.summary = "the distance of two points";
  kind.universes = {Universe::plane, Universe::space};
  kind.points = 2;
  kind.restriction = [](Universe) { return 1; };
  kind.measure = [](const ConstraintPlace& place) { return norm(place.vector(0, 1)); };
  kind.possible = {0, std::numeric_limits<double>::infinity()};
  kind.interpretations = {
      {"squared", "|PQ|^2 = h^2, a polynomial",
       [](const ConstraintPlace& place, const std::optional<Expression>& h) {
         return std::vector{squared_norm(place.vector(0, 1)) - sqr(*h)};
       }},
      {"norm", "|PQ| = h, not smooth where the points meet",
       [](const ConstraintPlace& place, const std::optional<Expression>& h) {
         return std::vector{norm(place.vector(0, 1)) - *h};
       },
       [](const ConstraintPlace& place) { return std::vector{squared_norm(place.vector(0, 1))}; }}};
  return kind;
}

}  // namespace gcslab
