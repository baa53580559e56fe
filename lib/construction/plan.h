#pragma once

// Construction plans: a triangular list of instructions, each of which places one point where planes and
// spheres around earlier points meet.
//
// A plan constructs the figures of a constraint system from the values of its parameters and of *guide*
// parameters, distances that the system does not give. Where an instruction intersects a sphere with planes
// and other spheres there are two places, on either side of the plane (the line, in the plane) through which
// the centres go: a *branch* says for each such instruction which one. The constraints that a plan does not
// use are *removed*: figures on which they hold are solutions of the system (reparametrisation: Gao,
// Hoffmann, Yang 2004; Imbach 2013, chapter 4).
//
// The first point is the origin, the second lies on the positive x axis, the third, in space, in the xy
// plane.

#include <optional>
#include <string>
#include <vector>

#include "construction/locus.h"

namespace gcslab {

/// A distance of two points that a plan needs to be given.
struct Guide {
  std::size_t point, centre;
};

/// Where a locus comes from: a constraint, of which it is number `part`, or a guide.
struct LocusSource {
  std::optional<std::size_t> constraint;
  std::size_t part = 0;
  std::optional<std::size_t> guide;
};

struct PlanStep {
  std::size_t point;
  /// As many as the point has degrees of freedom: 0, 1, 2, ... for the first points.
  std::vector<LocusSource> loci;
  /// Number of its choice among those of the plan; nothing where there is one place: the first two points,
  /// and where planes meet.
  std::optional<std::size_t> choice;
};

struct Plan {
  std::vector<PlanStep> steps;
  std::vector<Guide> guides;
  std::vector<std::size_t> removed;  ///< constraints

  std::size_t choices() const;
  Frame frame(Universe universe) const;  ///< the first points
};

/// "P3 = sphere(P0, h3) * sphere(P1, k0) * locus(coplanar P0 P1 P2 P3)", one line a step, then the guides and
/// what is removed.
std::string text_of(const Plan& plan, const ConstraintSystem& system);

/// How the order of the points is chosen, and what places them.
enum class PlanKind {
  /// From every frame, always the point that the most constraints place next, with guides for what is
  /// wanting: without guides the method of loci (LIM) by forward propagation.
  forward,
  /// From the end: a point that the fewest of the constraints between those left are about is the last one
  /// (Gao, Hoffmann, Yang 2004); without guides LIM by backward propagation.
  gao,
  /// With the least number of guides among all orders.
  least,
  /// Of `forward`, but by distances alone, of constraints or guides (Henneberg 1911, steps of type 1).
  henneberg
};

/// A plan of the points of the system. Loci are chosen that meet at large angles in `figure`. Throws
/// NotApplicable where the system has other objects than points or its coordinates are held by constraints,
/// where a point cannot be placed beside the others, and for kind `least` where there are more than 22
/// points: 2^n sets are looked at.
Plan make_plan(const ConstraintSystem& system, PlanKind kind, const Figure& figure);

/// Orders of the points, one from each frame, those whose plans need the fewest guides first. Throws
/// NotApplicable as make_plan.
std::vector<std::vector<std::size_t>> plan_orders(const ConstraintSystem& system, PlanKind kind);
/// The plan that places the points in that order, otherwise as make_plan.
Plan make_plan(const ConstraintSystem& system, const std::vector<std::size_t>& order, PlanKind kind,
               const Figure& figure);

/// A plan without guides, whose figures on all branches are all figures on which the constraints that it uses
/// hold (the method of loci, LIM): in `frame` where that does, else in another; nothing where there is none.
/// Throws NotApplicable as make_plan.
std::optional<Plan> plan_without_guides(const ConstraintSystem& system, const Frame& frame);

}  // namespace gcslab
