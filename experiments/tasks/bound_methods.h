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

/// Loads the problem of a job or command and checks that it is of one of the kinds. Throws InputError.
Problem load_problem_of_kind(const std::string& name_or_path, const std::vector<std::string>& kinds);

}  // namespace gcslab
