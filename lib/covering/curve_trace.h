#pragma once

// Polylines along an implicit curve, for drawing only: nothing is proved of them.

#include <array>
#include <vector>

#include "expression/expression.h"
#include "interval/interval.h"

namespace gcslab {

using Polyline = std::vector<std::array<double, 2>>;

/// Marching squares (Lorensen, Cline 1987, in the plane) for f(x, y) = 0 on a grid of resolution x resolution
/// squares. Follows sign changes only: a double component, where f touches 0, is not seen.
std::vector<Polyline> trace_curve(Expression function, const Box& box, int resolution);

}  // namespace gcslab
