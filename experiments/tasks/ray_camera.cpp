#include "experiments/tasks/ray_camera.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"

namespace gcslab {
namespace {

constexpr double kDistance = 6;  ///< of the eye, in radii of the box

Point3 cross(const Point3& a, const Point3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

}  // namespace

Point3 operator+(const Point3& a, const Point3& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
Point3 operator-(const Point3& a, const Point3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Point3 operator*(double factor, const Point3& a) { return {factor * a[0], factor * a[1], factor * a[2]}; }
double dot(const Point3& a, const Point3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Point3 normalised(const Point3& a) { return (1 / std::sqrt(dot(a, a))) * a; }

RayCamera::RayCamera(const Box& box, const Point3& direction, double zoom, int pixels)
    : box_(box), pixels_(pixels) {
  if (box.size() != 3 || !std::ranges::all_of(box, is_bounded))
    throw NotApplicable("rays are cast in a bounded box with three sides");
  if (direction[0] == 0 && direction[1] == 0) throw InputError("the direction of view must not be upright");
  const Point3 half = {radius(box[0]), radius(box[1]), radius(box[2])};
  const double size = std::sqrt(dot(half, half));
  const Point3 back = normalised(direction);
  const Point3 right = normalised(cross({0, 0, 1}, back));
  const Point3 up = cross(back, right);
  // Tangents of the sphere around the box from the eye bound the view.
  const double half_picture = size / std::sqrt(1 - 1 / (kDistance * kDistance)) / zoom;
  centre_ = {midpoint(box[0]), midpoint(box[1]), midpoint(box[2])};
  eye_ = centre_ + (kDistance * size) * back;
  right_ = half_picture * right;
  up_ = half_picture * up;
  light_ = normalised(back + 0.8 * up - 0.6 * right);
}

std::optional<Segment3> RayCamera::segment(int column, int row) const {
  const auto place = [this](int number) { return (2.0 * number + 1) / pixels_ - 1; };
  const Point3 ray = centre_ + place(column) * right_ + place(row) * up_ - eye_;
  double first = 0;
  double last = 2;  // the box ends before twice the distance of its middle
  for (std::size_t i = 0; i < 3; ++i) {
    if (ray[i] == 0 && !contains(box_[i], eye_[i])) return std::nullopt;
    if (ray[i] == 0) continue;
    const double lower = (box_[i].lower - eye_[i]) / ray[i];
    const double upper = (box_[i].upper - eye_[i]) / ray[i];
    first = std::max(first, std::min(lower, upper));
    last = std::min(last, std::max(lower, upper));
  }
  if (!(first < last)) return std::nullopt;
  return Segment3{eye_ + first * ray, eye_ + last * ray};
}

}  // namespace gcslab
