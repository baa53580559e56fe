#pragma once

// Bisection by the smears of the equations and by what their combinations leave over.

#include <memory>

#include "box_solver/bisection.h"

namespace gcslab {

/// Scores of two origins in equal parts: relative_smear_sum, which looks at each equation alone (Trombettoni,
/// Araya, Neveu, Chabert 2011), and the same idea for the combinations that the multiplier contractor makes
/// of equations: those that are solved for the variables, and the more the nearer it is to success, the one
/// that comes nearest to a constant, which would show that the box is empty. In a combination a term that has
/// z_j to the power p loses 1 - 2^-p of its size when side j is halved; these losses over the size of the
/// whole count for j. So cuts avoid variables whose terms the multipliers cancel, as factors that occur
/// linearly in all equations. The combined part is ours; unbounded boxes have none.
std::unique_ptr<Bisection> make_combined_smear(const SystemFunctions& functions);

}  // namespace gcslab
