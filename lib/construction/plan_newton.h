#pragma once

// Values of the guide parameters for which the figure of a plan satisfies the removed constraints too:
// searches at t = 1 on one branch after the other, as they were proposed before paths were followed.

#include <set>

#include "construction/branch_map.h"

namespace gcslab {

struct BranchSolution {
  std::vector<double> guides;  ///< over the unit
  Branch branch;
};

struct BranchSearch {
  std::vector<BranchSolution> solutions;
  std::uint64_t evaluations = 0;  ///< of the plan, on one branch
  /// Branches on which the search ended without a solution: never inside of the domain; at its border or in
  /// a minimum of |F|; in the last iteration.
  std::size_t outside = 0, stuck = 0, unfinished = 0;
  std::set<std::size_t> negative{};  ///< choices with a negative radicand where branches start outside
};

/// Newton's iteration from these guides on every branch, a step halved until it stays in the domain and |F|
/// shrinks (Fabre, Schreck 2008).
BranchSearch newton_on_branches(BranchMap& map, const std::vector<double>& guides);

/// The zeros of F on `samples` intervals of [0, largest] on every branch, for one guide: a sign change is
/// bisected, and taken for a zero where F becomes small (Gao, Hoffmann, Yang 2004). Throws NotApplicable for
/// more guides.
BranchSearch sample_branches(BranchMap& map, double largest, std::size_t samples);

}  // namespace gcslab
