#pragma once

// A proof that nothing is missing, for systems whose unknowns are found block by block where planes and
// spheres meet.
//
// Theorem. Let blocks of variables, each variable in one of them, have as many equations each, which are
// polynomials of the variables of the block and those before it: in the block's own, X, either of degree 1,
// or f |X|^2 and a part of degree 1, with a number f. Then the solutions of the system are among the figures
// that come from choosing, block after block, one of the common points of the block's planes and spheres:
// where one is a sphere, subtracting its equation makes planes of the others, and X = Q + h u with h^2 = r on
// the line in which they meet.
//
// Proof. The equations of a block hold at a solution, and with the earlier values say just that. (The method
// of loci; Imbach 2013, section 6.1.)
//
// The common points are enclosed by formulas of the verifier's own. Where 256 bits do not tell two from none,
// or planes may be parallel, one enclosure holds them all.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "verifier/judged_system.h"

namespace gcslab::verifier {

struct LociBlock {
  std::vector<std::size_t> variables;
  std::vector<std::size_t> equations;
};

/// What keeps the theorem from showing that every solution in the search box is accounted for: a hypothesis
/// that does not hold, or an enclosure of figures that `is_accounted_for` denies; nothing where all is shown.
std::optional<std::string> loci_theorem_gap(JudgedSystem& system, const Box& search_box,
                                            const std::vector<LociBlock>& blocks,
                                            const std::function<bool(const RangeBox&)>& is_accounted_for);

}  // namespace gcslab::verifier
