#include "geometry/frame.h"

#include <algorithm>
#include <fmt/format.h>
#include <set>

namespace gcslab {
namespace {

bool contains_all(const std::vector<std::size_t>& whole, const std::vector<std::size_t>& part) {
  return std::ranges::all_of(part, [&](std::size_t p) { return std::ranges::find(whole, p) != whole.end(); });
}

/// Whether it is a distance of two points.
bool is_side(const Constraint& constraint) {
  return constraint.kind->name == "distance" && constraint.kind->is_about_points();
}

/// The point of the constraint that is not among those.
std::size_t other_point(const Constraint& constraint, const std::vector<std::size_t>& known) {
  const auto is_new = [&](std::size_t p) { return std::ranges::find(known, p) == known.end(); };
  return *std::ranges::find_if(constraint.objects, is_new);
}

/// Frames worth a look: triples (in the plane pairs) of points that constraints tie together.
std::set<Frame> candidates(const ConstraintSystem& system) {
  const std::size_t size = dimension(system.universe);
  std::set<Frame> result;
  const auto propose = [&](Frame points) {
    std::ranges::sort(points);
    points.erase(std::unique(points.begin(), points.end()), points.end());
    if (points.size() == size) result.insert(std::move(points));
  };
  for (const Constraint& a : system.constraints) {
    if (!a.kind->is_about_points()) continue;
    if (a.objects.size() == size) propose(a.objects);
    for (std::size_t left = 0; a.objects.size() == size + 1 && left < a.objects.size(); ++left) {
      Frame points = a.objects;
      points.erase(points.begin() + static_cast<std::ptrdiff_t>(left));
      propose(points);
    }
    if (!is_side(a)) continue;
    for (const Constraint& b : system.constraints) {
      if (!is_side(b)) continue;
      Frame points = a.objects;
      points.insert(points.end(), b.objects.begin(), b.objects.end());
      propose(points);
    }
  }
  Frame first;
  for (std::size_t p = 0; p < size; ++p) first.push_back(p);
  result.insert(first);
  return result;
}

/// Absorbed constraints, then distances within the frame.
std::pair<std::ptrdiff_t, std::ptrdiff_t> worth(const ConstraintSystem& system, const Frame& frame) {
  const auto is_within = [&](const Constraint& c) { return is_side(c) && contains_all(frame, c.objects); };
  return {std::ranges::count(framed_coordinates(system, frame).is_absorbed, true),
          std::ranges::count_if(system.constraints, is_within)};
}

}  // namespace

Frame frame_of(const ConstraintSystem& system) {
  if (system.frame) return *system.frame;
  if (system.points() < dimension(system.universe))
    throw InputError(fmt::format("{} points are too few for a frame of {}; say frame: none", system.points(),
                                 dimension(system.universe)));
  Frame best;
  std::pair<std::ptrdiff_t, std::ptrdiff_t> most = {-1, -1};
  for (const Frame& frame : candidates(system)) {
    const auto found = worth(system, frame);
    if (found <= most) continue;
    most = found;
    best = frame;
  }
  return best;
}

FramedCoordinates framed_coordinates(const ConstraintSystem& system, const Frame& frame) {
  const std::size_t axes = dimension(system.universe);
  FramedCoordinates result{std::vector(system.points(), std::vector<bool>(axes, false)),
                           std::vector<bool>(system.constraints.size(), false)};
  if (frame.empty()) return result;
  const auto set_zero = [&](std::size_t point, std::size_t first_axis) {
    for (std::size_t axis = first_axis; axis < axes; ++axis) result.is_zero[point][axis] = true;
  };
  for (std::size_t k = 0; k < frame.size(); ++k) set_zero(frame[k], k);
  const std::vector<std::size_t> axis_points(frame.begin(), frame.begin() + 2);
  for (std::size_t c = 0; c < system.constraints.size(); ++c) {
    const Constraint& constraint = system.constraints[c];
    const bool is_on_axis =
        constraint.kind->name == "collinear" && contains_all(constraint.objects, axis_points);
    const bool is_in_plane = constraint.kind->name == "coplanar" && contains_all(constraint.objects, frame);
    if (!is_on_axis && !is_in_plane) continue;
    result.is_absorbed[c] = true;
    set_zero(other_point(constraint, is_on_axis ? axis_points : frame), is_on_axis ? 1 : 2);
  }
  return result;
}

}  // namespace gcslab
