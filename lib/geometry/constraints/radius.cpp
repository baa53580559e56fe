#include "geometry/constraint_kind.h"

namespace gcslab {
namespace {

ConstraintKind radius_of(Sort sort, const std::vector<Universe>& universes) {
  ConstraintKind kind;
  kind.name = "radius";
  kind.summary = "the radius of a " + name_of(sort);
  kind.universes = universes;
  kind.sorts = {sort};
  kind.measure = [](const ConstraintPlace& place) { return *place.objects[0].radius; };
  kind.possible = kAnyLength;
  kind.interpretations = {
      {"coordinate", "r = a", [](const ConstraintPlace& place, const std::optional<Expression>& a) {
         return std::vector{*place.objects[0].radius - *a};
       }}};
  return kind;
}

}  // namespace

std::vector<ConstraintKind> radius_constraints() {
  return {radius_of(Sort::circle, {Universe::plane, Universe::space}),
          radius_of(Sort::sphere, {Universe::space})};
}

}  // namespace gcslab
