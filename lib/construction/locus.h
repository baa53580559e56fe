#pragma once

// Where a constraint lets one point be when everything else that it names has its place: a plane or a sphere
// (in the plane: a line or a circle), or nothing that a construction intersects.
//
// A locus is read off the equations of the constraint, whatever its kind: as a polynomial in the coordinates
// of the point, F is of degree 1 or its part of degree 2 is a multiple of |X|^2. So a distance gives a
// sphere, a coplanarity, a volume and a right angle between a known and an unknown direction a plane, equal
// lengths a sphere or the plane between two points.

#include <memory>
#include <vector>

#include "geometry/constraint_system.h"
#include "geometry/frame.h"

namespace gcslab {

/// Expressions in all coordinates, as coordinate_variables numbers them, and then the parameters, of a
/// constraint system, and then the guide parameters of a plan.
struct FigureVariables {
  explicit FigureVariables(const ConstraintSystem& system);

  std::shared_ptr<ExpressionGraph> graph = std::make_shared<ExpressionGraph>();
  std::vector<Vector> coordinates;     ///< of each object
  std::vector<Expression> parameters;  ///< of the constraints
  int count;                           ///< of all variables
  std::vector<bool> is_absorbed;       ///< constraints that hold by the system's own frame
};

struct Locus {
  /// F, which vanishes on it: |X|^2 + ... of spheres, a polynomial of degree 1 in X of planes.
  Expression equation;
  bool is_sphere;
  bool is_absorbed = false;  ///< a coordinate is 0, by the frame
};

/// The loci of a point on whose intersection a constraint holds; none where they are no planes and spheres.
/// The constraint names the point. Where the system's own frame absorbs it, and all other points are of
/// `frame`, it is that coordinates are 0.
std::vector<Locus> loci_of(const ConstraintSystem& system, const Constraint& constraint, std::size_t point,
                           const Frame& frame, const FigureVariables& variables);

/// The sphere of the points at that distance from a point.
Locus sphere_around(std::size_t point, std::size_t centre, Expression distance,
                    const FigureVariables& variables);

}  // namespace gcslab
