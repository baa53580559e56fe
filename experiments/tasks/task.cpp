#include "experiments/tasks/task.h"

#include <nlohmann/json.hpp>

#include "base/content_hash.h"
#include "base/registry.h"

namespace gcslab {
namespace {

/// Keys in order of name: equal values, equal text.
using SortedJson = nlohmann::json;

SortedJson canonical(const Options& options) {
  SortedJson json = SortedJson::object();
  for (const auto& [name, value] : options.values()) json[name] = to_string(value);
  return json;
}

}  // namespace

std::string Job::id() const {
  const SortedJson identity = {{"problem", problem_hash},
                               {"task", task},
                               {"method", method},
                               {"method_version", method_version},
                               {"options", canonical(options)},
                               {"parameters", canonical(parameters)},
                               {"seed", seed}};
  return content_hash(identity.dump());
}

std::string Job::place() const {
  std::string text = problem + ", " + label;
  for (const auto& [name, value] : parameters.values()) text += ", " + name + "=" + to_string(value);
  return text + ", seed=" + std::to_string(seed);
}

MethodInfo Task::method(std::string_view method_name) const {
  return Registry<MethodInfo>("method of " + name(), methods()).at(method_name);
}

}  // namespace gcslab
