#include "geometry/constraint_kind.h"

namespace gcslab {
namespace {

Expression product_of_segments(const ConstraintPlace& place) {
  return dot(place.vector(0, 1), place.vector(2, 3));
}

Expression product_of_directions(const ConstraintPlace& place) {
  return dot(place.objects[0].direction, place.objects[1].direction);
}

ConstraintKind kind_of(const std::vector<Sort>& sorts, const std::string& summary,
                       const std::vector<Universe>& universes) {
  ConstraintKind kind;
  kind.name = "perpendicular";
  kind.summary = summary;
  kind.universes = universes;
  kind.sorts = sorts;
  return kind;
}

ConstraintKind by_product(ConstraintKind kind, const std::string& formula,
                          Expression (*product)(const ConstraintPlace&)) {
  kind.interpretations = {
      {"product", formula, [product](const ConstraintPlace& place, const std::optional<Expression>&) {
         return std::vector{product(place)};
       }}};
  return kind;
}

}  // namespace

std::vector<ConstraintKind> perpendicular_constraints() {
  const std::vector<Universe> both = {Universe::plane, Universe::space}, space = {Universe::space};
  ConstraintKind points =
      by_product(kind_of(std::vector(4, Sort::point), "the directions PQ and RS are perpendicular", both),
                 "PQ.RS = 0", product_of_segments);
  points.is_about_pairs = true;
  ConstraintKind mixed = kind_of({Sort::line, Sort::plane}, "a line is perpendicular to a plane", space);
  mixed.restriction = [](Universe) { return 2; };
  mixed.auxiliaries = &auxiliaries_of_multiple;
  mixed.interpretations = {{"multiple", "n = s u, with an unknown s",
                            [](const ConstraintPlace& place, const std::optional<Expression>&) {
                              return multiple_equations(place, place.objects[0].direction,
                                                        place.objects[1].direction);
                            }}};
  return {points,
          by_product(kind_of({Sort::line, Sort::line}, "the directions of two lines are perpendicular", both),
                     "u.v = 0", product_of_directions),
          by_product(kind_of({Sort::plane, Sort::plane}, "two planes are perpendicular", space), "n.n' = 0",
                     product_of_directions),
          mixed};
}

}  // namespace gcslab
