#pragma once

// Rays from an eye through the pixels of a square picture of a box.
//
// What is cast along a ray is the segment between two points with double coordinates, about where the ray
// enters and leaves the box. These points define the ray: rounding errors move it by a part of a pixel, and
// everything said of it holds for the segment as it is. No library function but sqrt is used, so that rays
// are the same on every machine.

#include <array>
#include <optional>

#include "interval/interval.h"

namespace gcslab {

using Point3 = std::array<double, 3>;

Point3 operator+(const Point3& a, const Point3& b);
Point3 operator-(const Point3& a, const Point3& b);
Point3 operator*(double factor, const Point3& a);
double dot(const Point3& a, const Point3& b);
/// Of length 1, to rounding; not for the zero vector.
Point3 normalised(const Point3& a);

struct Segment3 {
  Point3 from;
  Point3 to;
};

class RayCamera {
 public:
  /// Looks at the middle of the box, which has three bounded sides, from that direction, which is neither
  /// zero nor upright (the third axis points up). With zoom 1 the sphere around the box fills the picture.
  RayCamera(const Box& box, const Point3& direction, double zoom, int pixels);

  /// The part of the box that the ray through a pixel sees; columns go right, rows up. Nothing where the ray
  /// misses the box.
  std::optional<Segment3> segment(int column, int row) const;
  /// Towards a lamp above the viewer's left shoulder.
  const Point3& light() const { return light_; }

 private:
  Box box_;
  int pixels_;
  Point3 centre_, eye_, right_, up_, light_;  ///< right and up: half of the picture
};

}  // namespace gcslab
