#include "geometry/constraint_kind.h"

namespace gcslab {
namespace {

using Equations = std::vector<Expression>;

/// n.X - d of the position of one object and the normal form of another.
Expression height(const Vector& position, const ObjectParts<Expression>& flat) {
  return dot(flat.direction, position) - *flat.offset;
}

Equations point_on_line(const ConstraintPlace& place, const std::optional<Expression>&) {
  if (place.universe == Universe::plane) return {height(place.objects[0].position, place.objects[1])};
  return multiple_equations(place, place.objects[1].direction, place.vector(1, 0));
}

Equations point_on_plane(const ConstraintPlace& place, const std::optional<Expression>&) {
  return {height(place.objects[0].position, place.objects[1])};
}

Equations point_on_sphere(const ConstraintPlace& place, const std::optional<Expression>&) {
  return {squared_norm(place.vector(1, 0)) - sqr(*place.objects[1].radius)};
}

Equations point_on_circle(const ConstraintPlace& place, const std::optional<Expression>& none) {
  Equations equations = point_on_sphere(place, none);
  if (place.universe == Universe::space)
    equations.push_back(dot(place.objects[1].direction, place.vector(1, 0)));
  return equations;
}

Equations line_in_plane(const ConstraintPlace& place, const std::optional<Expression>&) {
  return {dot(place.objects[0].direction, place.objects[1].direction),
          height(place.objects[0].position, place.objects[1])};
}

ConstraintKind kind_of(const std::vector<Sort>& sorts, const std::string& summary,
                       const Interpretation& interpretation, bool is_one_more_in_space) {
  ConstraintKind kind;
  kind.name = "incidence";
  kind.summary = summary;
  kind.universes = {Universe::space};
  if (exists_in(sorts[1], Universe::plane)) kind.universes.push_back(Universe::plane);
  kind.sorts = sorts;
  kind.nearness = Nearness::radii;
  kind.restriction = [is_one_more_in_space](Universe universe) {
    return is_one_more_in_space && universe == Universe::space ? 2 : 1;
  };
  kind.interpretations = {interpretation};
  return kind;
}

}  // namespace

std::vector<ConstraintKind> incidence_constraints() {
  ConstraintKind on_line =
      kind_of({Sort::point, Sort::line}, "a point lies on a line",
              {"line", "n.P = d in the plane; P - m = s u in space, with an unknown s", point_on_line}, true);
  on_line.auxiliaries = &auxiliaries_of_multiple;
  return {on_line,
          kind_of({Sort::point, Sort::plane}, "a point lies on a plane", {"plane", "n.P = d", point_on_plane},
                  false),
          kind_of({Sort::point, Sort::circle}, "a point lies on a circle",
                  {"circle", "|P - c|^2 = r^2, and n.(P - c) = 0 in space", point_on_circle}, true),
          kind_of({Sort::point, Sort::sphere}, "a point lies on a sphere",
                  {"sphere", "|P - c|^2 = r^2", point_on_sphere}, false),
          kind_of({Sort::line, Sort::plane}, "a line lies in a plane",
                  {"directions", "u.n = 0, n.m = d", line_in_plane}, true)};
}

}  // namespace gcslab
