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
/// A dear part is called only where it pays, by a model of the search. Let a box be D halvings larger than
/// the boxes that the other parts empty, let these save g halvings a box beside the 1 of a cut, and the dear
/// part h more at R times their cost: then 2^(D / (1 + g)) boxes are ahead, or 2^(D / (1 + g + h)) dear ones,
/// and it pays when D / (1 + g) - D / (1 + g + h) >= log2(1 + R). D, g, h and R are means over what the
/// search has met; on boxes whose number is a power of 2 the part is tried whatever they say.
std::unique_ptr<Contractor> make_fixpoint_contractor(std::vector<CompositionPart> parts, double ratio,
                                                     int maximum_rounds);

}  // namespace gcslab
