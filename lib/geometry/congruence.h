#pragma once

// Figures that are the same up to isometry.

#include <vector>

#include "geometry/universe.h"
#include "interval/interval.h"

namespace gcslab {

/// A side for each coordinate of each point: [point][axis].
using FigureBox = std::vector<Box>;

/// Figures by number, grouped by what their distances tell, each group ascending, groups by their first
/// member. Two figures are congruent, mirror images included, when all distances between their points are the
/// same: figures whose boxes allow that are in one class.
std::vector<std::vector<std::size_t>> congruence_classes(const std::vector<FigureBox>& figures);

}  // namespace gcslab
