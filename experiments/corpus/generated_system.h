#pragma once

// Problem files whose equations a generator makes: key `generator` with its `name` in place of `equations`.

#include "base/yaml_reader.h"
#include "expression/equation_system.h"

namespace gcslab {

/// Throws InputError with file and line.
EquationSystem read_generated_system(const YamlNode& problem, const YamlNode& generator);

}  // namespace gcslab
