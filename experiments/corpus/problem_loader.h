#pragma once

// Problems by the names users give them.

#include <string>
#include <vector>

#include "experiments/corpus/problem.h"

namespace gcslab {

/// Loads a path or corpus name and checks that it is of one of the kinds. Throws InputError.
Problem load_problem_of_kind(const std::string& name_or_path, const std::vector<std::string>& kinds,
                             const std::string& valuation = {});

/// Kinds of YAML files that are systems of equations over a box.
const std::vector<std::string>& system_kinds();

/// Loads a system to be solved; a constraint system with the values of that valuation. Throws InputError.
Problem load_system(const std::string& name_or_path, const std::string& valuation = {});

}  // namespace gcslab
