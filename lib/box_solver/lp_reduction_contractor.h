#pragma once

#include <string>

#include "box_solver/contractor.h"
#include "box_solver/polytope.h"
#include "linear_program/lp_reduction.h"

namespace gcslab {

struct LpReductionSettings {
  std::string backend = "simplex";  ///< a registered solver of linear programs
  LpSafety safety = LpSafety::dual;
  BoundProducts products = BoundProducts::factors;
};

/// LP reduction: each side of the box is moved to the least and largest value of its variable over the
/// Bernstein polytope (polytope.h), or the box is discarded where that is empty. Boxes must be bounded;
/// others are left as they are.
std::unique_ptr<Contractor> make_lp_reduction_contractor(const SystemFunctions& functions,
                                                         const LpReductionSettings& settings);

/// "dual", "exact", "tolerance" or "unprotected". Throws InputError for another word.
LpSafety lp_safety_from_name(const std::string& name);

}  // namespace gcslab
