#pragma once

// Points of a curve with their tangents, and the cubic between two of them.

#include <optional>
#include <vector>

#include "homotopy/bordered_matrix.h"
#include "homotopy/curve.h"

namespace gcslab {

struct CurvePoint {
  std::vector<double> v;
  std::vector<double> tangent;  ///< of length 1, in the direction of travel
  /// The sign of det (J; tangent). It is the same all along a curve on which J has rank m.
  int orientation = 0;
};

double dot(const std::vector<double>& a, const std::vector<double>& b);
double norm(const std::vector<double>& a);
double distance(const std::vector<double>& a, const std::vector<double>& b);
/// The absolute value of the largest coordinate.
double largest(const std::vector<double>& a);

/// A cubic on [0, 1] by its ends and its derivatives there (Hermite).
struct Cubic {
  double start, start_slope, end, end_slope;

  double at(double u) const {
    const double w = 1 - u;
    return w * w * (1 + 2 * u) * start + u * w * w * start_slope + u * u * (3 - 2 * u) * end -
           u * u * w * end_slope;
  }
  double slope(double u) const {
    const double w = 1 - u;
    return 6 * u * w * (end - start) + w * (w - 2 * u) * start_slope + u * (u - 2 * w) * end_slope;
  }
};

/// Coordinate i of the cubic between two points of a curve, `span` apart.
inline Cubic cubic_between(const CurvePoint& a, const CurvePoint& b, double span, std::size_t i) {
  return {a.v[i], span * a.tangent[i], b.v[i], span * b.tangent[i]};
}

/// The point of that cubic at u in [0, 1].
std::vector<double> point_between(const CurvePoint& a, const CurvePoint& b, double u);

/// Unit tangents, by one factorisation each.
class TangentSolver {
 public:
  explicit TangentSolver(Curve& curve);
  /// The tangent at point.v on the side of `along`, and the orientation; false where J is undefined or (J;
  /// along) is singular.
  bool find(CurvePoint& point, std::span<const double> along);
  /// One change of Newton's method by what was found for the point, to which it is applied; its length.
  double polish(CurvePoint& point);
  /// (J; along) of the last point.
  const BorderedMatrix& matrix() const { return matrix_; }

 private:
  Curve* curve_;
  BorderedMatrix matrix_;
  std::vector<double> values_, zero_, change_;
  Matrix<double> jacobian_;
};

/// The point with the tangent on the side of growing t; on either side where t turns back. Throws
/// NotApplicable, with the reason, where the Jacobian is undefined or has no full rank.
CurvePoint starting_point(Curve& curve, const std::vector<double>& start);

}  // namespace gcslab
