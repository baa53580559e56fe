#pragma once

// What a drawing of a figure shows: points with names, lines between them, faces, and the parameters that
// stand at lines and angles.

#include <string>
#include <vector>

#include "geometry/constraint_system.h"

namespace gcslab {

struct WireEdge {
  std::size_t from, to;
  std::string label{};    ///< "c = 5", or empty
  bool is_guide = false;  ///< no length is given: an arm of an angle, a line that others are parallel to
};

struct WireAngle {
  std::size_t at, from, to;
  std::string label{};  ///< "a = 60°"
};

struct Wireframe {
  std::vector<std::string> names;
  Figure points;  ///< coordinates, all of two or all of three numbers
  std::vector<WireEdge> edges;
  std::vector<std::vector<std::size_t>> faces;  ///< each a cycle of edges whose points lie in one plane
  std::vector<WireAngle> angles;
};

/// The lines, faces and labels of the points of a constraint system's figures, without coordinates: an edge
/// for each distance, a guide for each other pair of points that a constraint speaks of, a face where
/// coplanar points (coplanarities with three common points are one) lie on a cycle of edges.
Wireframe wireframe_of(const ConstraintSystem& system, const Valuation& valuation);

/// A figure in the frame, reflected so that the first coordinate of each axis that is not 0 (along x of the
/// frame's second point, along y of its third one) is positive. Figures that differ by reflections look the
/// same then. Without a frame the figure stays as it is.
Figure reflected_upright(Figure figure, const Frame& frame);

}  // namespace gcslab
