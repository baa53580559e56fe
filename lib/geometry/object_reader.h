#pragma once

// Objects that a user draws, each where it is.

#include "base/yaml_reader.h"
#include "geometry/sort.h"

namespace gcslab {

/// The coordinates (sort.h) of an object of that sort: of a point [x, y] or [x, y, z]; of a line {through:
/// [P, Q]}, or {point: P, direction: u}; of a plane {through: [P, Q, R]}, or {point: P, normal: n}; of a
/// circle {centre: P, radius: r}, in space with normal: n; of a sphere {centre: P, radius: r}. Throws
/// InputError with file and line.
std::vector<double> read_object(const YamlNode& node, Sort sort, Universe universe);

}  // namespace gcslab
