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

bool ConstraintKind::is_about_points() const {
  return std::ranges::all_of(sorts, [](Sort sort) { return sort == Sort::point; });
}

ConstraintRegistry::ConstraintRegistry(const std::vector<std::vector<ConstraintKind>>& words) {
  for (const std::vector<ConstraintKind>& word : words) {
    for (const ConstraintKind& kind : word) {
      GCSLAB_CHECK(kind.name == word.front().name && std::ranges::is_sorted(kind.sorts));
      kinds_.push_back(kind);
    }
    GCSLAB_CHECK(std::ranges::find(names_, word.front().name) == names_.end());
    names_.push_back(word.front().name);
  }
}

std::vector<const ConstraintKind*> ConstraintRegistry::kinds(std::string_view name) const {
  std::vector<const ConstraintKind*> result;
  for (const ConstraintKind& kind : kinds_) {
    if (kind.name == name) result.push_back(&kind);
  }
  return result;
}

const ConstraintKind& ConstraintRegistry::at(std::string_view name) const {
  const auto found = std::ranges::find(kinds_, name, &ConstraintKind::name);
  if (found == kinds_.end()) throw InputError(unknown_name_message("constraint", name, names_));
  return *found;
}

const ConstraintRegistry& constraint_registry() {
  static const ConstraintRegistry registry({
      distance_constraints(),
      angle_constraints(),
      area_constraints(),
      volume_constraints(),
      radius_constraints(),
      incidence_constraints(),
      centre_constraints(),
      tangent_constraints(),
      collinear_constraints(),
      coplanar_constraints(),
      parallel_constraints(),
      perpendicular_constraints(),
      equal_lengths_constraints(),
      fixed_coordinate_constraints(0),
      fixed_coordinate_constraints(1),
      fixed_coordinate_constraints(2),
  });
  return registry;
}

}  // namespace gcslab
