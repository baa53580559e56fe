#pragma once

#include "box_solver/contractor.h"

namespace gcslab {

struct BoxConsistencyOptions {
  double first_slice = 0.125;  ///< part of the side that is tried first
  double precision = 0.01;     ///< a sweep ends where a slice of this part of the side is not refuted
  int bits = 53;
};

/// Box consistency (Benhamou, McAllester, Van Hentenryck 1994): for each function and each of its variables,
/// slices are cut off both ends of the variable's side where the function, evaluated over the rest of the
/// box, cannot be 0 (an inequality's: cannot be <= 0). Slices grow while they are refuted and shrink where
/// they are not, so that no derivative is needed and functions need not be defined everywhere.
///
/// Variables that occur once in a function are left to hull consistency, which is as strong there. So are
/// unbounded sides.
template <class T>
std::unique_ptr<Contractor> make_box_consistency_contractor(const SystemFunctions& functions,
                                                            const BoxConsistencyOptions& options = {});

}  // namespace gcslab
