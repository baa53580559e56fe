#pragma once

// How near the guides of a plan are to the border of its domain on a branch, where a radicand is 0.

#include <optional>

#include "construction/branch.h"

namespace gcslab {

struct PlanBorder {
  /// The least radicand of a choice over the square of the size of the values, the largest parameter or
  /// guide; its choice.
  double least_radicand;
  std::size_t least_choice;
  /// min r / |grad r| over the choices, with derivatives by the guides: to first order how far the guides can
  /// move before r is 0, in their unit. Infinite where no radicand depends on them; 0 on the border.
  double distance;
  std::size_t nearest_choice;  ///< of that minimum; the least radicand's where the distance is infinite
};

/// Nothing outside of the domain, where an instruction fails otherwise, and for plans without choices.
std::optional<PlanBorder> border_of(const PlanProgram& program, const PlanValues& values,
                                    const Branch& branch);

}  // namespace gcslab
