#pragma once

// Figures that a user draws: moved into the frame, and read.

#include "geometry/constraint_system.h"

namespace gcslab {

/// The point nearest to the origin of the line through a point along a direction of length 1.
std::vector<double> nearest_to_origin(std::vector<double> point, const std::vector<double>& direction);

/// The figure moved rigidly so that the frame's points have their zero coordinates, the second one x >= 0,
/// the third one y >= 0. Throws InputError when the frame's points are on a line (in the plane: are one
/// point).
Figure in_frame(const ConstraintSystem& system, const Frame& frame, const Figure& figure);

/// The same for any figure of a path: where the points of the frame are on a line (at one place), one of the
/// turns about it that leave the frame's coordinates 0, which puts another object in the xy plane (on the x
/// axis) where one is not on that line.
Figure in_frame_or_on_line(const ConstraintSystem& system, const Frame& frame, const Figure& figure);

/// Whether the points of the frame are on a line (in the plane: at one place), so that in_frame throws.
bool is_frame_flat(const Frame& frame, const Figure& figure);

/// How far the points of a frame in space are from a line: the height of their triangle over its longest
/// side. In the plane: 1.
double frame_height(const Frame& frame, const Figure& figure);

/// What the figure shows for each parameter: the measure of the first constraint that has it. Throws
/// InputError that names the constraint when its measure is undefined there.
std::vector<double> parameters_of(const ConstraintSystem& system, const Figure& figure);

/// The parameters of a valuation, rounded.
std::vector<double> values_of(const Valuation& valuation);

/// The user's sketch, or a random one; nothing when there is none. Random points, centres, and points of
/// lines and planes have coordinates uniform in a cube around 0, radii are uniform in [0, half its side]; the
/// size is the one that makes the squares of the distances of points that constraints name add up to what is
/// wanted in the first valuation.
std::optional<Figure> sketch_of(const ConstraintSystem& system);

}  // namespace gcslab
