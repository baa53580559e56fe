#pragma once

// What a constraint of some kind says of its points, as equations.
//
// Each kind is one file of lib/geometry/constraints and one line of constraint_registry.cpp. Metric kinds
// have a parameter, the value of their measure; boolean ones are what they say. Everything is an expression
// in the coordinates of the points, so that solvers differentiate, bound and export it like any other.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/registry.h"
#include "geometry/universe.h"
#include "geometry/vector_algebra.h"
#include "interval/interval.h"

namespace gcslab {

/// The points that a constraint names, by their coordinates, and its auxiliary unknowns.
struct ConstraintPlace {
  Universe universe;
  std::vector<Vector> points;
  std::vector<Expression> auxiliaries{};

  /// From point number `from` to point number `to`.
  Vector vector(std::size_t from, std::size_t to) const { return difference(points[to], points[from]); }
};

/// That one vector is a multiple of another: det(u, v) = 0 in the plane; v = s u in space, with an unknown s.
std::size_t auxiliaries_of_multiple(Universe universe);
std::vector<Expression> multiple_equations(const ConstraintPlace& place, const Vector& u, const Vector& v);

/// One way to write a constraint. Equations are expressions that vanish where it holds.
struct Interpretation {
  std::string name;
  std::string summary;
  /// The parameter is that of metric kinds.
  std::function<std::vector<Expression>(const ConstraintPlace&, const std::optional<Expression>& parameter)>
      equations;
  /// The equations are smooth where none of these vanishes. Null: everywhere.
  std::function<std::vector<Expression>(const ConstraintPlace&)> not_smooth_at{};
};

struct ConstraintKind {
  std::string name;
  std::string summary;
  std::vector<Universe> universes;              ///< where it makes sense
  std::size_t points;                           ///< that it names
  std::vector<Interpretation> interpretations;  ///< the first is the default
  /// How many degrees of freedom it takes.
  std::function<int(Universe)> restriction;
  /// Unknowns that its equations have beside the points.
  std::function<std::size_t(Universe)> auxiliaries = [](Universe) { return std::size_t{0}; };
  /// Metric kinds: what a figure shows for the parameter. Null: boolean.
  std::function<Expression(const ConstraintPlace&)> measure{};
  /// Metric kinds: the values that a figure can show.
  Interval possible = Interval::entire();
  /// It is about pairs of points, which may share a point; otherwise all points differ.
  bool is_about_pairs = false;
  /// Boolean kinds: the metric one that is 0 exactly where they hold. Empty: none.
  std::string metric_form{};

  bool is_metric() const { return measure != nullptr; }
  bool takes(Universe universe) const;
};

const Registry<ConstraintKind>& constraint_registry();

// One function a file of lib/geometry/constraints.
ConstraintKind distance_constraint();
ConstraintKind angle_constraint();
ConstraintKind area_constraint();
ConstraintKind volume_constraint();
ConstraintKind collinear_constraint();
ConstraintKind coplanar_constraint();
ConstraintKind parallel_constraint();
ConstraintKind perpendicular_constraint();
ConstraintKind equal_lengths_constraint();
/// fixed_x, fixed_y, fixed_z.
ConstraintKind fixed_coordinate_constraint(std::size_t axis);

}  // namespace gcslab
