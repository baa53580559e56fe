#pragma once

// How far from the origin of the frame the objects of every solution are.

#include <vector>

#include "geometry/constraint_system.h"

namespace gcslab {

/// Upper bounds, maybe infinite.
struct Reach {
  double distance;  ///< of a point, a centre, the nearest point of a line or plane
  double radius;    ///< of a circle or sphere
};

/// For each object, along constraints that keep two objects near each other (Nearness): the shortest way
/// (Dijkstra 1959) from the first point of the frame. A way leads on from points and centres, and from a line
/// to the plane that contains it, which is no farther; from other objects no other need be near.
std::vector<Reach> reaches_of(const ConstraintSystem& system, const Frame& frame, const Valuation& valuation);

}  // namespace gcslab
