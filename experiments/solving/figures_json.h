#pragma once

// The keys of a result that tell what the solutions of a constraint system look like.

#include "experiments/corpus/problem.h"
#include "experiments/solving/result_json.h"
#include "experiments/solving/solve_run.h"

namespace gcslab {

/// Adds "figures", the coordinates of all points for each solution, in their order, and "classes", the
/// numbers of solutions that are the same up to isometry.
void add_figures(Json& result, const GeometricSource& source, const SearchResult& found);

/// Adds "paths": how each ended, how long it is, where on it which solution lies and where branches cross;
/// and to each solution without a certificate the rank of its Jacobian, and whether others are beside it.
void add_paths(Json& result, const std::vector<FollowedPath>& paths);

/// Adds "plan": the construction plan as lines of text, and what is counted of it.
void add_plan(Json& result, const PlanReport& plan);

}  // namespace gcslab
