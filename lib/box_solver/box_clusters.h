#pragma once

#include <vector>

#include "box_solver/search.h"

namespace gcslab {

/// Replaces undecided boxes that touch each other or nearly do by their hull, as long as the hull is small
/// against the search box: the many boxes around one multiple root become one. Every point of a box given
/// lies in a box returned.
std::vector<UndecidedBox> clustered(std::vector<UndecidedBox> boxes, const Box& search_box);

}  // namespace gcslab
