#pragma once

// Figures of several solved systems side by side: what is the same figure up to isometry stands in one line.

#include <optional>
#include <vector>

#include "experiments/solving/figure_picture.h"

namespace gcslab {

/// One entry a column: which of the column's figures stands there, if any.
using AlignedLine = std::vector<std::optional<std::size_t>>;

/// The lines of a table with a column for each picture; null: a column without figures. Figures with the same
/// names are the same when all distances between their points agree to a millionth of the largest one, and,
/// where there are other objects, they may be congruent (congruence.h) with coordinates known as well as
/// that; such as no earlier column has follow below. Every figure stands in exactly one line.
std::vector<AlignedLine> aligned_classes(const std::vector<const FigurePicture*>& columns);

}  // namespace gcslab
