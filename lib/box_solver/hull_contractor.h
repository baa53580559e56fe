#pragma once

#include "box_solver/contractor.h"

namespace gcslab {

/// Hull consistency by forward-backward propagation through each equation and inequality as it is written
/// (HC4-revise, Benhamou, Goualard, Granvilliers, Puget 1999), repeated for the functions whose variables
/// shrank by more than the part `ratio` of their width.
template <class T>
std::unique_ptr<Contractor> make_hull_contractor(const SystemFunctions& functions, double ratio,
                                                 int bits = 53);

}  // namespace gcslab
