#pragma once

// What a drawing of a figure shows: points with names, edges between them, faces, lines, planes, circles and
// spheres, and the parameters that stand at edges, angles and objects.

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

/// An object that is no point.
struct WireObject {
  std::string name;
  Sort sort;
  std::vector<double> place{};  ///< its coordinates, as sort.h lists them
};

/// What a metric constraint measures where neither an edge nor an angle at a point shows it.
struct WireMeasure {
  std::string kind;                  ///< the word of the constraint: distance, angle, radius, area, volume
  std::vector<std::size_t> objects;  ///< numbers of points, and from `names.size()` on of the other objects
  std::string label;                 ///< "r = 2"
};

struct Wireframe {
  std::vector<std::string> names;  ///< of the points
  Figure points;                   ///< coordinates, all of two or all of three numbers
  std::vector<WireEdge> edges;
  std::vector<std::vector<std::size_t>> faces;  ///< each a cycle of edges whose points lie in one plane
  std::vector<WireAngle> angles;
  std::vector<WireObject> objects{};
  std::vector<WireMeasure> measures{};

  Universe universe() const;
  /// The points and objects as one figure, points first; their sorts.
  Figure figure() const;
  std::vector<Sort> sorts() const;
  /// The same lines and labels with the coordinates of that figure, which may end after the points.
  Wireframe at(const Figure& figure) const;
};

/// The edges, faces, objects and labels of a constraint system's figures, without coordinates: an edge for
/// each distance of two points, a guide for each other pair of points that a constraint speaks of, a face
/// where coplanar points (coplanarities with three common points are one) lie on a cycle of edges.
Wireframe wireframe_of(const ConstraintSystem& system, const Valuation& valuation);

/// A figure in the frame, reflected so that the first coordinate of each axis that is not 0 (along x of the
/// frame's second point, along y of its third one, else of any position) is positive. Figures that differ by
/// reflections look the same then. Without a frame the figure stays as it is. It may be of points alone.
Figure reflected_upright(Figure figure, const std::vector<Sort>& sorts, const Frame& frame);

}  // namespace gcslab
