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

ConstraintKind angle_at_a_point() {
  ConstraintKind kind;
  kind.name = "angle";
  kind.summary = "the angle at the second of three points, between 0 and pi";
  kind.universes = {Universe::plane, Universe::space};
  kind.sorts = std::vector(3, Sort::point);
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

Expression cosine(const ConstraintPlace& place) {
  return dot(place.objects[0].direction, place.objects[1].direction);
}

/// |u.v| = f(a), f the cosine, or the sine where one direction is a normal.
ConstraintKind angle_of_directions(const std::vector<Sort>& sorts, const std::vector<Universe>& universes) {
  const bool is_mixed = sorts[0] != sorts[1];
  const Operation function = is_mixed ? Operation::sin : Operation::cos;
  const Operation inverse = is_mixed ? Operation::asin : Operation::acos;
  ConstraintKind kind;
  kind.name = "angle";
  kind.summary = "the angle of " + text_of(sorts) + ", between 0 and pi/2";
  kind.universes = universes;
  kind.sorts = sorts;
  kind.measure = [inverse](const ConstraintPlace& place) {
    const Expression size = apply(Operation::abs, cosine(place));
    return apply(inverse, size.graph().apply(Operation::min, size, size.graph().constant(1)));
  };
  kind.possible = {0, 1.5707963267948968};  // above pi/2
  kind.interpretations = {{"squared",
                           is_mixed ? "(u.n)^2 = sin^2 a, for 0 < a < pi/2: parallel is regular at 0"
                                    : "(u.v)^2 = cos^2 a, for 0 < a < pi/2: perpendicular is regular at pi/2",
                           [function](const ConstraintPlace& place, const std::optional<Expression>& a) {
                             return std::vector{sqr(cosine(place)) - sqr(apply(function, *a))};
                           }}};
  return kind;
}

}  // namespace

std::vector<ConstraintKind> angle_constraints() {
  return {angle_at_a_point(),
          angle_of_directions({Sort::line, Sort::line}, {Universe::plane, Universe::space}),
          angle_of_directions({Sort::plane, Sort::plane}, {Universe::space}),
          angle_of_directions({Sort::line, Sort::plane}, {Universe::space})};
}

}  // namespace gcslab
