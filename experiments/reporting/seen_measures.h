#pragma once

// Where the parameters of constraints on lines, planes, circles and spheres stand in a drawing.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "experiments/reporting/seen_objects.h"

namespace gcslab {

/// An angle: its arms from a point.
struct SeenAngle {
  SeenPoint at, from, to;
};

struct SeenMeasure {
  std::string label;
  /// Thin lines that show what is measured: from a point to its foot on a line or plane, from a centre to the
  /// rim, arms of angles that are not drawn, the sides of a triangle, the edges of a parallelepiped.
  std::vector<std::array<SeenPoint, 2>> guides{};
  std::optional<SeenAngle> angle{};   ///< the label stands at its arc
  std::optional<SeenPoint> middle{};  ///< the label stands there; else beside the first guide
};

/// Of the measures of a figure that is placed; a measure that has no room (the angle of lines that meet far
/// away, a distance that is 0) has none.
std::vector<SeenMeasure> seen_measures(const Wireframe& figure, const View& view);

}  // namespace gcslab
