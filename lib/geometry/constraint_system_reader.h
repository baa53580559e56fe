#pragma once

// Constraint systems as users write them (YAML, kind constraint_system).

#include "base/yaml_reader.h"
#include "geometry/constraint_system.h"

namespace gcslab {

/// The keys that read_constraint_system takes; others are the caller's.
const std::vector<std::string>& constraint_system_keys();

/// Reads universe, points, lines, planes, circles, spheres, constraints, valuations, sketch and frame. Throws
/// InputError with file and line, and with the constraint's name where one is at fault.
ConstraintSystem read_constraint_system(const YamlNode& problem);

/// Reads {random: SEED}, or where every object of the system is, in place of the sketch that it has. Throws
/// InputError likewise.
void read_sketch(const YamlNode& node, ConstraintSystem& system);

}  // namespace gcslab
