#include <algorithm>

#include "geometry/constraint_kind.h"

namespace gcslab {

bool ConstraintKind::takes(Universe universe) const {
  return std::ranges::find(universes, universe) != universes.end();
}

const Registry<ConstraintKind>& constraint_registry() {
  static const Registry<ConstraintKind> registry("constraint", {
                                                                   distance_constraint(),
                                                                   angle_constraint(),
                                                                   area_constraint(),
                                                                   volume_constraint(),
                                                                   collinear_constraint(),
                                                                   coplanar_constraint(),
                                                                   parallel_constraint(),
                                                                   perpendicular_constraint(),
                                                                   equal_lengths_constraint(),
                                                                   fixed_coordinate_constraint(0),
                                                                   fixed_coordinate_constraint(1),
                                                                   fixed_coordinate_constraint(2),
                                                               });
  return registry;
}

}  // namespace gcslab
