#pragma once

// What is special about a figure: points that meet, lie on a line or in a plane, or are far away.

#include <string>

#include "geometry/constraint_system.h"

namespace gcslab {

/// Sets of objects by number, each ascending; the largest ones, none contained in another of its kind.
struct Degeneracies {
  std::vector<std::vector<std::size_t>> coincident;  ///< at least 2 points at one place
  std::vector<std::vector<std::size_t>> collinear;   ///< at least 3 places on a line
  std::vector<std::vector<std::size_t>> coplanar;  ///< at least 4 places in a plane, no three of them special
  std::vector<std::size_t> far;                    ///< more than 1000 units from the first point
  bool is_all_coplanar = false;
};

/// Up to `tolerance` times the unit, the size of usual figures; more than `far` units is far. What the
/// constraints themselves demand is left out. Planes are looked for among at most 60 points.
Degeneracies degeneracies_of(const ConstraintSystem& system, const Figure& figure, double unit,
                             double tolerance = 1e-6, double far = 1e3);

/// "P0 and P3 coincide; P1, P2, P4 are collinear"; empty when nothing is special.
std::string text_of(const Degeneracies& degeneracies, const ConstraintSystem& system);

/// The constraint whose equations are not smooth at a figure nearer than `tolerance` units; nothing where all
/// are smooth.
std::optional<std::size_t> constraint_not_smooth_at(const ConstraintSystem& system, const Figure& figure,
                                                    double unit, double tolerance = 1e-6);

}  // namespace gcslab
