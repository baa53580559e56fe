#include "expression/variable_names.h"

#include <algorithm>
#include <cctype>

#include "expression/parser.h"

namespace gcslab {

std::string free_variable_name(std::string_view wanted, std::set<std::string>& taken) {
  std::string name(wanted);
  std::ranges::replace_if(
      name, [](unsigned char c) { return std::isalnum(c) == 0 || c > 127; }, '_');
  while (!is_variable_name(name) || taken.contains(name)) name += '_';
  taken.insert(name);
  return name;
}

ForeignNames foreign_names(std::span<const std::string> variables,
                           const std::function<bool(const std::string&)>& is_allowed) {
  std::set<std::string> taken;
  for (const std::string& name : variables) {
    if (is_allowed(name)) taken.insert(name);
  }
  ForeignNames result;
  for (const std::string& name : variables) {
    if (is_allowed(name)) {
      result.names.push_back(name);
      continue;
    }
    std::string other = "v_" + name;
    while (!is_allowed(other) || taken.contains(other)) other += '_';
    taken.insert(other);
    result.names.push_back(other);
    result.renamed.emplace_back(other, name);
  }
  return result;
}

}  // namespace gcslab
