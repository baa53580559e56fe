#include "experiments/tasks/bound_methods.h"

#include "enclosure/bound_registry.h"
#include "experiments/corpus/problem.h"

namespace gcslab {

std::vector<MethodInfo> bound_methods() {
  std::vector<MethodInfo> methods;
  for (const BoundVariant& bound : bound_registry().entries()) {
    methods.push_back({bound.name, bound.summary, Promise::rigorous, bound.version, bound.options});
  }
  return methods;
}

SetBounds make_bounds(const Problem& problem, const std::string& method, const Options& options) {
  const BoundVariant& variant = bound_registry().at(method);
  const auto make = [&](const std::vector<Expression>& functions) {
    std::vector<std::unique_ptr<RangeBound>> bounds;
    for (const BoundTarget& target : problem.targets(functions))
      bounds.push_back(variant.make(target, options));
    return bounds;
  };
  try {
    return {make(problem.system.equations), make(problem.system.inequalities)};
  } catch (const NotApplicable& reason) {
    throw NotApplicable(method + " " + reason.what());
  }
}

}  // namespace gcslab
