#pragma once

// Where a curve crosses a level of t, between two of its points.

#include <optional>
#include <vector>

#include "homotopy/curve_point.h"

namespace gcslab {

/// Whether t takes the level between the points, or at the second one.
bool crosses(double level, const CurvePoint& a, const CurvePoint& b);

/// Whether t, by the cubic, crosses the level between the points and comes back.
bool crosses_twice(double level, const CurvePoint& a, const CurvePoint& b);

struct LevelPoint {
  std::vector<double> v;  ///< v.back() is the level
  std::size_t rank;       ///< of the m by m Jacobian by the other coordinates, as far as doubles tell
};

/// The point between a and b with that level, which t crosses: the cubic's, improved by Newton's method with
/// t fixed, and where the Jacobian is singular by least changes. Nothing where the equations are undefined.
std::optional<LevelPoint> point_at(double level, Curve& curve, const CurvePoint& a, const CurvePoint& b);

/// Whether t, by the cubic, turns back between the points so near to the level that the cubic does not tell
/// on which side.
bool turns_near(double level, const CurvePoint& a, const CurvePoint& b);

/// The point of the curve between a and b at which t turns back, with its tangent. Nothing where it cannot be
/// found.
std::optional<CurvePoint> turning_point(Curve& curve, const CurvePoint& a, const CurvePoint& b);

/// The rank of the Jacobian by the coordinates but t, as far as doubles tell.
std::size_t rank_at(Curve& curve, const std::vector<double>& v);

/// Moves v to the curve by Newton's method with t fixed; false where it does not converge, or to where the
/// Jacobian by the other coordinates is singular, as far as doubles tell.
bool solve_at_level(Curve& curve, std::vector<double>& v);

/// Whether a solution of the same level, at a small distance in a direction of the Jacobian's kernel, can be
/// found: numerical evidence that v, at which it is singular, lies on a continuum of solutions.
bool lies_on_continuum(Curve& curve, const std::vector<double>& v);

}  // namespace gcslab
