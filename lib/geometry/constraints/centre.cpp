#include "geometry/constraint_kind.h"

namespace gcslab {
namespace {

ConstraintKind centre_of(Sort sort, const std::vector<Universe>& universes) {
  ConstraintKind kind;
  kind.name = "centre";
  kind.summary = "a point is the centre of a " + name_of(sort);
  kind.universes = universes;
  kind.sorts = {Sort::point, sort};
  kind.restriction = [](Universe universe) { return static_cast<int>(dimension(universe)); };
  kind.nearness = Nearness::together;
  kind.interpretations = {
      {"coordinates", "c = P",
       [](const ConstraintPlace& place, const std::optional<Expression>&) { return place.vector(0, 1); }}};
  return kind;
}

}  // namespace

std::vector<ConstraintKind> centre_constraints() {
  return {centre_of(Sort::circle, {Universe::plane, Universe::space}),
          centre_of(Sort::sphere, {Universe::space})};
}

}  // namespace gcslab
