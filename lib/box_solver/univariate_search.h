#pragma once

// Every real solution of one polynomial equation in one variable, with its multiplicity.
//
// Promise: as of search.h, but that multiple roots are solutions too and unbounded boxes are searched to
// their ends. Undecided are only roots that no doubles can tell apart, and the whole box when the equation is
// 0 = 0. Exact (lib/univariate), so that no precision is asked for.

#include "box_solver/search.h"

namespace gcslab {

/// Throws NotApplicable, with the reason, unless there is one variable and one equation, which is a
/// polynomial of degree 200 at most (as far as the verifier expands polynomials). The proof, when one is
/// wanted, says that the verifier may count the roots.
SearchResult univariate_search(const SystemFunctions& functions, const Box& search_box, ProofLog* proof,
                               const std::stop_token& stop = {});

}  // namespace gcslab
