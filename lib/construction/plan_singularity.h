#pragma once

// Where a plan is singular: figures in which the loci of an instruction are not in general position, so that
// it does not place its point.

#include "construction/branch.h"

namespace gcslab {

struct PlanSingularity {
  std::size_t step;
  /// Of the angles between the planes of its loci, that of two spheres included, as |det| or |a x b| over the
  /// product of lengths: 0 where centres are on a line or planes parallel. Where the normal of a plane nearly
  /// vanishes, as that of the plane of three points near a line, how far it is from that in sizes of the
  /// figure, if that is less.
  double sine;
};

/// The step with the least sine, in a figure in the plan's frame; nothing where no step has a plane.
std::optional<PlanSingularity> least_general_step(const PlanProgram& program, const Figure& figure,
                                                  const std::vector<double>& parameters);

}  // namespace gcslab
