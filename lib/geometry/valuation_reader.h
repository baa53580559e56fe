#pragma once

// The values of the parameters of a constraint system, as users write them.

#include "base/yaml_reader.h"
#include "geometry/constraint_system.h"

namespace gcslab {

/// Reads a value for each parameter: a constant expression, maybe in degrees ("1.3", "sqrt(2)", "30 deg").
/// Throws InputError with file and line, and with the constraint whose measure no figure shows.
Valuation read_valuation(const std::string& name, const YamlNode& node, const ConstraintSystem& system);

}  // namespace gcslab
