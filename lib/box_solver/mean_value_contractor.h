#pragma once

#include "box_solver/contractor.h"

namespace gcslab {

/// How the preconditioned mean value form 0 = C f(m) + C J (x - m) is solved for each variable.
enum class MeanValueForm {
  gauss_seidel,  ///< row i is divided by its own coefficient (Hansen and Sengupta 1981)
  krawczyk       ///< x - C f(x) is enclosed instead: no division (Krawczyk 1969, Moore 1977)
};

/// Interval Newton methods: with m the midpoint of the box, J the slopes over it and C the approximate
/// inverse of the midpoint of J, row i of the preconditioned mean value form is solved for variable i, one
/// after the other, each with what the earlier ones left. Square systems only: throws NotApplicable for
/// others. A box is left as it is when it is unbounded, when an equation may be undefined in it, or when the
/// midpoint of J is singular.
template <class T>
std::unique_ptr<Contractor> make_mean_value_contractor(const SystemFunctions& functions, MeanValueForm form,
                                                       int bits = 53);

}  // namespace gcslab
