#include "geometry/constraint_kind.h"

namespace gcslab {
namespace {

ConstraintKind kind_of(const std::vector<Sort>& sorts, const std::string& summary,
                       const std::vector<Universe>& universes) {
  ConstraintKind kind;
  kind.name = "parallel";
  kind.summary = summary;
  kind.universes = universes;
  kind.sorts = sorts;
  return kind;
}

/// One direction is a multiple of the other.
ConstraintKind multiple(ConstraintKind kind, const std::string& summary, const std::string& name,
                        const std::function<std::pair<Vector, Vector>(const ConstraintPlace&)>& directions) {
  kind.restriction = [](Universe universe) { return universe == Universe::plane ? 1 : 2; };
  kind.auxiliaries = &auxiliaries_of_multiple;
  kind.interpretations = {
      {name, summary, [directions](const ConstraintPlace& place, const std::optional<Expression>&) {
         const auto [u, v] = directions(place);
         return multiple_equations(place, u, v);
       }}};
  return kind;
}

std::pair<Vector, Vector> segments(const ConstraintPlace& place) {
  return {place.vector(0, 1), place.vector(2, 3)};
}

std::pair<Vector, Vector> of_objects(const ConstraintPlace& place) {
  return {place.objects[0].direction, place.objects[1].direction};
}

}  // namespace

std::vector<ConstraintKind> parallel_constraints() {
  const std::vector<Universe> both = {Universe::plane, Universe::space}, space = {Universe::space};
  ConstraintKind points =
      multiple(kind_of(std::vector(4, Sort::point), "the lines PQ and RS are parallel", both),
               "det(PQ, RS) = 0 in the plane; RS = s PQ in space, with an unknown s", "multiple", segments);
  points.is_about_pairs = true;
  ConstraintKind mixed =
      kind_of({Sort::line, Sort::plane}, "a line is parallel to a plane, or lies in it", space);
  mixed.interpretations = {
      {"product", "u.n = 0", [](const ConstraintPlace& place, const std::optional<Expression>&) {
         const auto [u, n] = of_objects(place);
         return std::vector{dot(u, n)};
       }}};
  return {
      points,
      multiple(kind_of({Sort::line, Sort::line}, "two lines are parallel, or the same", both),
               "det(n, n') = 0 in the plane; u' = s u in space, with an unknown s", "multiple", of_objects),
      multiple(kind_of({Sort::plane, Sort::plane}, "two planes are parallel, or the same", space),
               "n' = s n, with an unknown s", "multiple", of_objects),
      mixed};
}

}  // namespace gcslab
