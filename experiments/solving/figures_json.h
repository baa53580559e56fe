#pragma once

// The keys of a result that tell what the solutions of a constraint system look like.

#include "experiments/corpus/problem.h"
#include "experiments/solving/result_json.h"

namespace gcslab {

/// Adds "figures", the coordinates of all points for each solution, in their order, and "classes", the
/// numbers of solutions that are the same up to isometry.
void add_figures(Json& result, const GeometricSource& source, const SearchResult& found);

}  // namespace gcslab
