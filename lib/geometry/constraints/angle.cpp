#include "geometry/constraint_kind.h"

namespace gcslab {
namespace {

Expression product(const ConstraintPlace& place) { return dot(place.vector(1, 0), place.vector(1, 2)); }

Expression lengths(const ConstraintPlace& place) {
  return norm(place.vector(1, 0)) * norm(place.vector(1, 2));
}

Expression apply(Operation operation, Expression e) { return e.graph().apply(operation, e); }

/// No angle is defined where an arm has no length.
std::vector<Expression> squared_lengths(const ConstraintPlace& place) {
  return {squared_norm(place.vector(1, 0)), squared_norm(place.vector(1, 2))};
}

}  // namespace

ConstraintKind angle_constraint() {
  ConstraintKind kind;
  kind.name = "angle";
  kind.summary = "the angle at the second of three points, between 0 and pi";
  kind.universes = {Universe::plane, Universe::space};
  kind.points = 3;
  kind.restriction = [](Universe) { return 1; };
  kind.measure = [](const ConstraintPlace& place) {
    return apply(Operation::acos, product(place) / lengths(place));
  };
  kind.possible = {0, 3.1415926535897936};  // above pi
  kind.interpretations = {{"product", "u.v = |u| |v| cos a, which holds where an arm has no length",
                           [](const ConstraintPlace& place, const std::optional<Expression>& a) {
                             return std::vector{product(place) - lengths(place) * apply(Operation::cos, *a)};
                           },
                           &squared_lengths},
                          {"quotient", "u.v / (|u| |v|) = cos a, undefined where an arm has no length",
                           [](const ConstraintPlace& place, const std::optional<Expression>& a) {
                             return std::vector{product(place) / lengths(place) - apply(Operation::cos, *a)};
                           },
                           &squared_lengths}};
  return kind;
}

}  // namespace gcslab
