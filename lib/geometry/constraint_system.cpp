#include "geometry/constraint_system.h"

#include <algorithm>
#include <fmt/format.h>

#include "base/nearest_name.h"

namespace gcslab {

std::string ConstraintSystem::describe(const Constraint& constraint) const {
  std::string text =
      fmt::format("constraint {}, {}", &constraint - constraints.data() + 1, constraint.kind->name);
  for (const std::size_t point : constraint.points) text += " " + points[point];
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
