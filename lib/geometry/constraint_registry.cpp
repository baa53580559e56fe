#include <algorithm>

#include "geometry/constraint_kind.h"

namespace gcslab {

std::size_t auxiliaries_of_multiple(Universe universe) { return universe == Universe::plane ? 0 : 1; }

std::vector<Expression> multiple_equations(const ConstraintPlace& place, const Vector& u, const Vector& v) {
  if (place.universe == Universe::plane) return {determinant(u, v)};
  std::vector<Expression> equations;
  for (std::size_t i = 0; i < v.size(); ++i) equations.push_back(v[i] - place.auxiliaries[0] * u[i]);
  return equations;
}

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
