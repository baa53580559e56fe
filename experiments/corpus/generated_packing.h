#pragma once

// Circle packings of random triangulations as problem files: the key `generator` is
//   {name: circle_packing, inner_discs: 20, flips: 1000, seed: 1, least_radius: 0.001}
// in place of variables, equations, inequalities and box. The outer discs have radii 1, 2, 3 and centres (0,
// 0), (3, 0), (0, 4). What the numbers mean: packing/random_triangulation.h and packing/packing_system.h.

#include "base/yaml_reader.h"
#include "expression/equation_system.h"

namespace gcslab {

/// Throws InputError with file and line.
EquationSystem read_circle_packing(const YamlNode& problem, const YamlNode& generator);

}  // namespace gcslab
