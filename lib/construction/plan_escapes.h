#pragma once

// Which points of a plan can go to infinity along a homotopy path, and what the figure looks like there.
//
// On a path that goes to infinity at a finite t, some point is the first of the plan to do so: those before
// it stay bounded, and it is a solution at infinity of its block, the loci that place it (Imbach 2013,
// section 4.2.2). A sphere of a constraint keeps it where its centre is, and so do distances to points before
// it, by way of later points too; a block has solutions at infinity otherwise, where its guides become
// infinite or its planes turn parallel to a line. Parameters are taken to be bounded, as they are where t is.

#include <string>
#include <vector>

#include "construction/plan.h"

namespace gcslab {

struct PlanEscape {
  std::size_t point;
  std::vector<std::size_t> guides;       ///< that become infinite
  std::vector<std::size_t> constraints;  ///< planes (lines) in which the point goes to infinity
  std::string configuration;             ///< "P3 infinitely far: k0 = distance P3 P0 infinite"
};

/// In the order of the plan; empty: no path goes to infinity while t stays bounded.
std::vector<PlanEscape> escapes_of(const Plan& plan, const ConstraintSystem& system);

/// The configuration of the first point of the plan that is farther than `far` from the plan's first point,
/// and the angles that go to 0 or 180 degrees there; empty where none is, or its block has no solution at
/// infinity.
std::string escape_met(const std::vector<PlanEscape>& escapes, const Plan& plan,
                       const ConstraintSystem& system, const Figure& figure, double far);

}  // namespace gcslab
