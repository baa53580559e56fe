#include "geometry/constraint_system.h"

#include <algorithm>
#include <fmt/format.h>

#include "base/nearest_name.h"

namespace gcslab {

std::size_t ConstraintSystem::points() const {
  return static_cast<std::size_t>(std::ranges::count(objects, Sort::point, &NamedObject::sort));
}

std::vector<std::string> ConstraintSystem::names() const {
  std::vector<std::string> result;
  for (const NamedObject& object : objects) result.push_back(object.name);
  return result;
}

std::string ConstraintSystem::describe(const Constraint& constraint) const {
  std::string text =
      fmt::format("constraint {}, {}", &constraint - constraints.data() + 1, constraint.kind->name);
  for (const std::size_t object : constraint.objects) text += " " + objects[object].name;
  return text;
}

const Valuation& ConstraintSystem::valuation(const std::string& name) const {
  if (name.empty()) return valuations.front();
  const auto found = std::ranges::find(valuations, name, &Valuation::name);
  if (found != valuations.end()) return *found;
  std::vector<std::string> known;
  for (const Valuation& valuation : valuations) known.push_back(valuation.name);
  throw InputError(unknown_name_message("valuation", name, known));
}

ConstraintPlace ConstraintSystem::place(const Constraint& constraint,
                                        const std::vector<Vector>& coordinates) const {
  ConstraintPlace result{universe, {}};
  for (const std::size_t k : constraint.objects)
    result.objects.push_back(parts_of(objects[k].sort, universe, coordinates[k]));
  return result;
}

std::vector<Vector> coordinate_variables(const ConstraintSystem& system, ExpressionGraph& graph) {
  std::vector<Vector> result;
  int count = 0;
  for (const NamedObject& object : system.objects) {
    Vector& variables = result.emplace_back();
    for (std::size_t i = 0; i < coordinate_names(object.sort, system.universe).size(); ++i)
      variables.push_back(graph.variable(count++));
  }
  return result;
}

std::vector<double> coordinates_in_order(const Figure& figure) {
  std::vector<double> result;
  for (const std::vector<double>& object : figure) result.insert(result.end(), object.begin(), object.end());
  return result;
}

}  // namespace gcslab
