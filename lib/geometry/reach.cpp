#include "geometry/reach.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "expression/constant_enclosure.h"

namespace gcslab {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double sum_above(double a, double b) { return a == 0 || b == 0 ? a + b : std::nextafter(a + b, kInfinity); }

double bound_of(const Constraint& constraint, const Valuation& valuation) {
  return magnitude(constant_enclosure(valuation.values[*constraint.parameter]));
}

double length_of(const Constraint& constraint, const Valuation& valuation,
                 const std::vector<Reach>& reaches) {
  switch (constraint.kind->nearness) {
    case Nearness::unknown:
      return kInfinity;
    case Nearness::together:
      return 0;
    case Nearness::parameter:
      return bound_of(constraint, valuation);
    case Nearness::radii:
      return sum_above(reaches[constraint.objects[0]].radius, reaches[constraint.objects[1]].radius);
  }
  return kInfinity;
}

bool leads_on(Sort from, Sort to) { return from == Sort::line ? to == Sort::plane : from != Sort::plane; }

}  // namespace

std::vector<Reach> reaches_of(const ConstraintSystem& system, const Frame& frame,
                              const Valuation& valuation) {
  std::vector<Reach> reaches;
  for (const NamedObject& object : system.objects)
    reaches.push_back({kInfinity, object.sort >= Sort::circle ? kInfinity : 0.0});
  for (const Constraint& constraint : system.constraints) {
    if (constraint.kind->name != "radius") continue;
    double& radius = reaches[constraint.objects[0]].radius;
    radius = std::min(radius, bound_of(constraint, valuation));
  }
  if (frame.empty()) return reaches;
  reaches[frame[0]].distance = 0;
  std::vector<bool> is_done(reaches.size(), false);
  for (std::size_t round = 0; round < reaches.size(); ++round) {
    std::size_t nearest = reaches.size();
    for (std::size_t k = 0; k < reaches.size(); ++k) {
      if (!is_done[k] && (nearest == reaches.size() || reaches[k].distance < reaches[nearest].distance))
        nearest = k;
    }
    is_done[nearest] = true;
    for (const Constraint& constraint : system.constraints) {
      const double length = length_of(constraint, valuation, reaches);
      for (const std::size_t end : {std::size_t{0}, std::size_t{1}}) {
        if (length == kInfinity || constraint.objects[end] != nearest) continue;
        const std::size_t other = constraint.objects[1 - end];
        if (!leads_on(system.objects[nearest].sort, system.objects[other].sort)) continue;
        double& distance = reaches[other].distance;
        distance = std::min(distance, sum_above(reaches[nearest].distance, length));
      }
    }
  }
  return reaches;
}

}  // namespace gcslab
