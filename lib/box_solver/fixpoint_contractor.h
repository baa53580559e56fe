#pragma once

#include "box_solver/contractor.h"

namespace gcslab {

/// Applies contractors one after the other, again while a round shrinks some side by at least the part
/// `ratio`, at most `maximum_rounds` times.
std::unique_ptr<Contractor> make_fixpoint_contractor(std::vector<std::unique_ptr<Contractor>> parts,
                                                     double ratio, int maximum_rounds);

}  // namespace gcslab
