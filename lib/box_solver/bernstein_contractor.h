#pragma once

#include "box_solver/contractor.h"

namespace gcslab {

/// How the coefficients of an equation, seen along one variable, bound where it vanishes.
enum class BernsteinProjection {
  hull,       ///< by the convex hull of all points (Sherbrooke and Patrikalakis 1993)
  polynomial  ///< by the polynomials of the lower and of the upper points (Mourrain and Pavone 2009)
};

/// Projection of the Bernstein form: on the box the equations of a polynomial system are combined so that
/// combination i depends on variable i most (least-squares multipliers of the Jacobian at the midpoint, its
/// inverse for a square system). Its tensor Bernstein coefficients, least and largest of each layer along
/// variable i, then bound where on that side it can vanish.
///
/// Throws NotApplicable for a system that is not polynomial, and for one whose tensors, equations times
/// prod (d_i + 1) with d_i the largest degree in variable i, have more coefficients than allowed: their
/// number grows exponentially with the variables. Unbounded boxes are left as they are.
template <class T>
std::unique_ptr<Contractor> make_bernstein_contractor(const SystemFunctions& functions,
                                                      BernsteinProjection projection, int bits = 53,
                                                      std::size_t maximum_coefficients = std::size_t{1}
                                                                                         << 20);

}  // namespace gcslab
