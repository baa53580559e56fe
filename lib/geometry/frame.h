#pragma once

// Rigid motions fixed by coordinates that are 0, and the constraints that hold by that alone.
//
// A coplanarity of the three points of a frame in space with a fourth holds when the fourth lies in the xy
// plane; a collinearity of the first two with a third when the third lies on the x axis: such constraints are
// absorbed. That is the same for every figure whose frame is no single line (or point). Reflections stay: the
// signs of the coordinates are free.

#include "geometry/constraint_system.h"

namespace gcslab {

struct FramedCoordinates {
  std::vector<std::vector<bool>> is_zero;  ///< [point][axis], other objects have none
  std::vector<bool> is_absorbed;           ///< one a constraint
};

/// The frame that the user said; else one that absorbs most constraints, and of these the one with most
/// distances between its points, the first in the order of points. Throws InputError when there are too few
/// points for a frame.
Frame frame_of(const ConstraintSystem& system);

FramedCoordinates framed_coordinates(const ConstraintSystem& system, const Frame& frame);

}  // namespace gcslab
