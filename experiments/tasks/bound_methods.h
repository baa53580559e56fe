#pragma once

// The registered range bounds as methods of a task.

#include <memory>
#include <vector>

#include "covering/cover.h"
#include "experiments/tasks/task.h"

namespace gcslab {

struct Problem;

std::vector<MethodInfo> bound_methods();

/// One bound for each equation and inequality of the problem. Throws NotApplicable, with the reason.
SetBounds make_bounds(const Problem& problem, const std::string& method, const Options& options);

}  // namespace gcslab
