#pragma once

// Lines, planes, circles and spheres as polylines: lines and planes end where the rest of the figure does.
//
// Everything is in the coordinates of the figure.

#include <optional>
#include <utility>
#include <vector>

#include "experiments/solving/wireframe.h"
#include "geometry/numeric_vector.h"

namespace gcslab {

/// The room that lines and planes of a figure are drawn in: a box around its points, circles and spheres, in
/// which each of its lines and planes has a point too, and the foot of each distance that is drawn. Sides are
/// wider than needed by a part of the longest.
struct Room {
  Numbers low, high;

  Numbers centre() const;
  /// Of the longest side; not 0.
  double size() const;
};

Room room_of(const Wireframe& figure);

/// The part of the line {point + s direction} within the room (Liang, Barsky 1984); nothing when it misses
/// it.
std::optional<std::pair<Numbers, Numbers>> clipped_line(const Numbers& point, const Numbers& direction,
                                                        const Room& room);

/// The two ends of a line, the corners of a rectangle in a plane, points around a circle; closed outlines end
/// where they begin. Planes show the rectangle over which the points, circles and spheres of the figure lie.
/// A line without a part in the room, and a sphere, which looks different from everywhere, have none.
std::vector<Numbers> outline_of(const WireObject& object, const Wireframe& figure, const Room& room);

/// Points around the circle with that centre, and that radius along two orthonormal axes; the last one is the
/// first.
std::vector<Numbers> circle_points(const Numbers& centre, const std::pair<Numbers, Numbers>& axes,
                                   double radius);

/// Two vectors that complete a direction of space to orthonormal axes, the first of them horizontal.
std::pair<Numbers, Numbers> axes_across(const Numbers& direction);

/// Some point of a line (in the plane or space) or plane, and the direction of a line.
Numbers point_of(const WireObject& object, Universe universe);
Numbers direction_of_line(const WireObject& line, Universe universe);
/// The point of a line or plane that is nearest to a point.
Numbers foot_on(const WireObject& object, Universe universe, const Numbers& point);

/// a + factor b.
Numbers along(Numbers a, double factor, const Numbers& b);

}  // namespace gcslab
