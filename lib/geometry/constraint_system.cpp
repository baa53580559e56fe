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

}  // namespace gcslab
