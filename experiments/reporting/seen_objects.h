#pragma once

// Lines, planes, circles and spheres on paper, and what they hide.

#include "experiments/reporting/axonometry.h"

namespace gcslab {

/// How an object that is no point is seen.
struct SeenObject {
  std::size_t number;  ///< among the objects of the wireframe
  Sort sort;
  std::vector<SeenPoint> outline;   ///< ends of a line, else closed; a sphere's is as far away as its centre
  std::vector<SeenPoint> relief{};  ///< of a sphere: the nearer half of its horizontal great circle
  SeenPoint centre{};               ///< of a sphere
  double radius = 0;                ///< of a sphere

  bool is_surface() const { return sort == Sort::plane || sort == Sort::sphere; }
  /// Whether a point is behind the rectangle of a plane, or in or behind a sphere. `slack` is how far behind
  /// a point must be.
  bool hides(const SeenPoint& point, double slack) const;
};

/// Those that have a part in the room of the figure (object_outline.h).
std::vector<SeenObject> seen_objects(const Wireframe& figure, const View& view);

/// How openly the planes, circles and lines of a figure of space are seen, from 0, where one is seen edge-on
/// or end-on, to 1. 1 without such objects.
double openness(const Wireframe& figure, const View& view);

}  // namespace gcslab
