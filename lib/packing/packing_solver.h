#pragma once

// The method `angle_sum`: a circle packing through its radii.
//
// 1. The radii, approximately, from the angle sums (angle_sum.h). 2. Their enclosure, with the proof that
// there are no others (radii_enclosure.h). 3. The places of the discs in intervals (circle_layout.h): a box
// that holds the packing. 4. Krawczyk's operator on the equations in x, y, r proves that this box has exactly
// one root.
// 5. That root is the packing; when it lies in the search box, its inequalities are proved and the theorem of
// packing_problem.h applies, no other solution is in the search box. Otherwise the whole search box is
// undecided, with the reason.

#include <stop_token>

#include "box_solver/search.h"

namespace gcslab {

struct PackingSolverOptions {
  int bits = 128;           ///< of the radii and places
  int maximum_bits = 1024;  ///< tried when these leave too wide a box
  ProofLog* proof = nullptr;
};

/// Promise: as search() of box_solver/search.h. Throws NotApplicable when the system is no packing.
SearchResult solve_packing(const SystemFunctions& functions, const Box& search_box,
                           const PackingSolverOptions& options, const std::stop_token& stop = {});

}  // namespace gcslab
