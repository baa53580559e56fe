#pragma once

#include "box_solver/contractor.h"

namespace gcslab {

struct CompositionPart {
  std::unique_ptr<Contractor> contractor;
  bool is_dear = false;
};

/// Applies the parts that are not dear one after the other, again while a round shrinks some side by at least
/// the part `ratio`, at most `maximum_rounds` times. When a round shrinks less, the dear parts have their
/// turn; one that shrinks a side by `ratio` starts the rounds anew.
///
/// A dear part is called only where it has paid: on the boxes above it saved at least as many halvings as the
/// logarithm of its cost relative to the other parts. Where it did not it is
/// left out for 1, 7, 31 levels of the search tree. What decides is handed down in the contractor's
/// memory, so that it does not depend on the order of the search.
std::unique_ptr<Contractor> make_fixpoint_contractor(std::vector<CompositionPart> parts, double ratio,
                                                     int maximum_rounds);

}  // namespace gcslab
