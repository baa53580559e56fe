#pragma once

// Lines, planes, circles and spheres on paper, and what they hide.

#include <array>
#include <optional>
#include <vector>

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
  /// The pieces of the outline beside which its name may stand: near the ends of a line and the corners of a
  /// plane, all around others.
  std::vector<std::array<SeenPoint, 2>> pieces_for_name() const;
};

/// Those that have a part in the room of the figure (object_outline.h).
std::vector<SeenObject> seen_objects(const Wireframe& figure, const View& view);

/// Planes and spheres, the farthest first.
std::vector<const SeenObject*> surfaces_from_the_rear(const std::vector<SeenObject>& objects);

/// Whether a plane or sphere hides a point, other than number `own`, of which the point is the outline.
bool is_hidden(const SeenPoint& point, const std::vector<SeenObject>& objects,
               const std::optional<std::size_t>& own, double slack);

/// How openly the planes, circles and lines of a figure of space are seen, from 0, where one is seen edge-on
/// or end-on, to 1. 1 without such objects.
double openness(const Wireframe& figure, const View& view);

}  // namespace gcslab
