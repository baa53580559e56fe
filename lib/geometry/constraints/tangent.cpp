#include "geometry/constraint_kind.h"

namespace gcslab {
namespace {

using Equations = std::vector<Expression>;

ConstraintKind kind_of(const std::vector<Sort>& sorts, Universe universe) {
  ConstraintKind kind;
  kind.name = "tangent";
  kind.summary = text_of(sorts) + " touch";
  kind.universes = {universe};
  kind.sorts = sorts;
  kind.nearness = Nearness::radii;
  return kind;
}

/// The distance of the centre from the line or plane is the radius.
ConstraintKind flat_and_round(Sort flat, Sort round, Universe universe) {
  ConstraintKind kind = kind_of({flat, round}, universe);
  kind.interpretations = {
      {"squared", flat == Sort::line && round == Sort::sphere ? "|(c - m) x u|^2 = r^2" : "(n.c - d)^2 = r^2",
       [](const ConstraintPlace& place, const std::optional<Expression>&) {
         const ObjectParts<Expression>&line = place.objects[0], &circle = place.objects[1];
         const Expression square = line.offset ? sqr(dot(line.direction, circle.position) - *line.offset)
                                               : squared_norm(cross(place.vector(0, 1), line.direction));
         return Equations{square - sqr(*circle.radius)};
       }}};
  return kind;
}

/// The squared distance of the centres less the square of r + r', or of r - r'.
Expression external(const ConstraintPlace& place) {
  return squared_norm(place.vector(0, 1)) - sqr(*place.objects[0].radius + *place.objects[1].radius);
}

Expression internal(const ConstraintPlace& place) {
  return squared_norm(place.vector(0, 1)) - sqr(*place.objects[0].radius - *place.objects[1].radius);
}

ConstraintKind two_round(Sort round, Universe universe) {
  ConstraintKind kind = kind_of({round, round}, universe);
  kind.interpretations = {{"any", "|cc'|^2 is (r + r')^2 or (r - r')^2: the product of the other two",
                           [](const ConstraintPlace& place, const std::optional<Expression>&) {
                             return Equations{external(place) * internal(place)};
                           }},
                          {"external", "|cc'|^2 = (r + r')^2",
                           [](const ConstraintPlace& place, const std::optional<Expression>&) {
                             return Equations{external(place)};
                           }},
                          {"internal", "|cc'|^2 = (r - r')^2: one within the other",
                           [](const ConstraintPlace& place, const std::optional<Expression>&) {
                             return Equations{internal(place)};
                           }}};
  return kind;
}

}  // namespace

std::vector<ConstraintKind> tangent_constraints() {
  return {flat_and_round(Sort::line, Sort::circle, Universe::plane),
          flat_and_round(Sort::line, Sort::sphere, Universe::space),
          flat_and_round(Sort::plane, Sort::sphere, Universe::space),
          two_round(Sort::circle, Universe::plane), two_round(Sort::sphere, Universe::space)};
}

}  // namespace gcslab
