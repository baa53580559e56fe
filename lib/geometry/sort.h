#pragma once

// The sorts of geometric objects, and the coordinates that say where one is.
//
// Directions have length 1, so that a line of the plane is {X : n.X = d}, a plane is the same in space, and a
// line in space is {m + s u} with m its point nearest to the origin, u.m = 0. (n, d) and (-n, -d), u and -u
// are one object: each line, plane and circle in space has two sets of coordinates.

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/check.h"
#include "geometry/universe.h"

namespace gcslab {

enum class Sort { point, line, plane, circle, sphere };

/// In the order in which a constraint system lists objects.
const std::vector<Sort>& all_sorts();
/// "point".
std::string name_of(Sort sort);
bool exists_in(Sort sort, Universe universe);
/// "a point and a line", "2 planes", "3 points, 2 lines": what a list of sorts, in order, is.
std::string text_of(const std::vector<Sort>& sorts);

/// What a coordinate tells: of a position one along an axis (of the point, of the centre, of a line's point
/// nearest to the origin), of a direction one along an axis (of the line in space, of the normal of every
/// other object), the offset d, the radius.
enum class Role { position, direction, offset, radius };

struct CoordinateName {
  std::string suffix;  ///< that follows "l_": x, nx, ux, d, r
  Role role;
};

/// The coordinates of an object in their order: by role.
const std::vector<CoordinateName>& coordinate_names(Sort sort, Universe universe);

/// The coordinates of an object by role; what it does not have is empty.
template <class Number>
struct ObjectParts {
  std::vector<Number> position{}, direction{};
  std::optional<Number> offset{}, radius{};
};

template <class Number>
ObjectParts<Number> parts_of(Sort sort, Universe universe, const std::vector<Number>& coordinates) {
  const std::vector<CoordinateName>& names = coordinate_names(sort, universe);
  GCSLAB_CHECK(names.size() == coordinates.size());
  ObjectParts<Number> parts;
  for (std::size_t i = 0; i < names.size(); ++i) {
    switch (names[i].role) {
      case Role::position:
        parts.position.push_back(coordinates[i]);
        break;
      case Role::direction:
        parts.direction.push_back(coordinates[i]);
        break;
      case Role::offset:
        parts.offset = coordinates[i];
        break;
      case Role::radius:
        parts.radius = coordinates[i];
        break;
    }
  }
  return parts;
}

/// The coordinates in their order: the inverse of parts_of.
template <class Number>
std::vector<Number> joined(const ObjectParts<Number>& parts) {
  std::vector<Number> coordinates = parts.position;
  coordinates.insert(coordinates.end(), parts.direction.begin(), parts.direction.end());
  if (parts.offset) coordinates.push_back(*parts.offset);
  if (parts.radius) coordinates.push_back(*parts.radius);
  return coordinates;
}

}  // namespace gcslab
