#pragma once

// Points of space on paper: an orthographic view of a box from its front corner, a little from above, so that
// the first axis runs to the right and the second to the left.

#include <array>
#include <vector>

#include "experiments/tasks/illustration.h"
#include "linear_program/exact_polytope.h"

namespace gcslab {

using SpacePoint = std::array<double, 3>;

/// The box that is seen as the unit cube.
struct SpaceView {
  std::array<double, 3> lower = {0, 0, 0};
  std::array<double, 3> upper = {1, 1, 1};
  double turned = -35;  ///< degrees about the upright axis; at 0 the first axis runs straight to the right

  /// Where a point stands on paper; the axes of the cube have about unit length there.
  RationalPoint seen(const SpacePoint& point) const;
  ControlPolygon seen(const std::vector<SpacePoint>& points) const;
  /// Whether a side of which this is the outward normal turns towards the reader.
  bool faces_reader(const SpacePoint& outward) const;
};

/// A panel without axes around all shapes.
Json space_panel(const std::string& title, Json shapes);

/// The three axes of the cube from its lower corner, with their names.
void add_axes(Json& shapes, const SpaceView& view, const std::array<std::string, 3>& names);

/// A polytope of three dimensions: filled, with its hidden edges dashed; `front` gets the edges that are
/// drawn over whatever stands inside.
void add_polytope(Json& shapes, Json& front, const SpaceView& view, const ExactPolytope& polytope);

}  // namespace gcslab
