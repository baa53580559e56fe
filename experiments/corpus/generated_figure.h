#pragma once

// Constraint systems that a generator makes: in a problem of kind constraint_system the key `generator` is
//   {name: polygon, vertices: 20, seed: 1, perturbation: 0.05}
// in place of universe, objects, constraints, valuations and frame; `sides: 5` for a prism. What the families
// are: figure_family.h. The sketch is the generator's too, unless the problem has the key `sketch`.

#include "base/yaml_reader.h"
#include "geometry/constraint_system.h"

namespace gcslab {

/// Throws InputError with file and line.
ConstraintSystem read_generated_figure(const YamlNode& problem, const YamlNode& generator);

}  // namespace gcslab
