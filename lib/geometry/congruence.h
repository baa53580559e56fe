#pragma once

// Figures that are the same up to isometry.

#include "geometry/sort.h"
#include "interval/interval.h"

namespace gcslab {

/// A side for each coordinate of each object: [object][coordinate].
using FigureBox = std::vector<Box>;

/// Figures by number, grouped, each group ascending, groups by their first member. Figures of objects of
/// these sorts are congruent, mirror images included, when the distances between their points and centres,
/// their radii, and the products of their directions with each other and with positions are the same for
/// some choice of the directions' signs, which are no part of a figure: figures whose boxes allow that are in
/// one class.
std::vector<std::vector<std::size_t>> congruence_classes(const std::vector<Sort>& sorts, Universe universe,
                                                         const std::vector<FigureBox>& figures);

}  // namespace gcslab
