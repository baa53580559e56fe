#pragma once

// The angle sums of a circle packing (Thurston 1978; Collins, Stephenson 2003, "A circle packing algorithm").
//
// Where discs of radii a, b, c touch each other, the triangle of their centres has at the centre of the first
// the angle 2 asin sqrt(b/(a+b) c/(a+c)) = 2 atan sqrt(bc / (a(a+b+c))). The angle sum of an inner vertex is
// that of its angles in all faces around it; radii are those of a packing exactly when every angle sum is 2
// pi. In the logarithms u of the radii the derivative of the angle sum of v by u_w, for an edge vw, is the
// sum of rho / (r_v + r_w) over the two faces at vw with rho = sqrt(abc / (a+b+c)) the radius of the
// inscribed circle; that by u_v is minus the sum over all neighbours. So the matrix is symmetric and,
// negated, an M-matrix.

#include <Eigen/SparseCholesky>
#include <optional>
#include <span>
#include <vector>

#include "packing/triangulation.h"

namespace gcslab {

/// Angle sums of the inner vertices in their order, for radii of all vertices. A NumberTraits<T>::Scope must
/// be alive; set-valued T give enclosures.
template <class T>
std::vector<T> angle_sums(const Triangulation& graph, std::span<const T> radii);

/// Solves (-J) x = b for the derivative J of the angle sums by the logarithms of the inner radii, in plain
/// doubles.
class AngleSumDerivative {
 public:
  /// At these radii of all vertices.
  AngleSumDerivative(const Triangulation& graph, std::span<const double> radii);
  /// Nothing when rounding made the matrix singular.
  std::optional<std::vector<double>> solve(std::span<const double> right_side) const;

 private:
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors_;
};

/// Approximate radii of all vertices, by a damped Newton iteration in the logarithms: it proves nothing.
/// Nothing when rounding stops it.
std::optional<std::vector<double>> approximate_radii(const Triangulation& graph,
                                                     const std::array<double, 3>& outer_radii);

}  // namespace gcslab
