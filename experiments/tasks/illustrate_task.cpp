#include "experiments/tasks/illustrate_task.h"

#include <algorithm>
#include <map>

#include "base/error.h"
#include "base/registry.h"
#include "experiments/corpus/corpus.h"
#include "experiments/corpus/problem.h"
#include "experiments/corpus/problem_loader.h"
#include "experiments/tasks/illustration.h"

namespace gcslab {
namespace {

// A new drawing is one line in its family's list.
const Registry<Illustration>& drawings() {
  static const Registry<Illustration> registry("method", [] {
    std::vector<Illustration> all;
    for (const auto& family :
         {bernstein_illustrations(), polytope_illustrations(), solver_illustrations(), plan_illustrations()})
      all.insert(all.end(), family.begin(), family.end());
    return all;
  }());
  return registry;
}

/// What sources print of the drawn, and the drawings compute.
const std::vector<ValueInfo>& published_facts() {
  static const std::vector<ValueInfo> facts = {
      {"half_spaces", "inequalities of the polytope"},
      {"vertices", "of the polytope, or their number where they are many"},
      {"volume", "of the polytope, exactly"},
      {"range", "of the polynomial, by linear programs over the polytope"},
      {"reduction", "what the first reduction leaves of the box"},
      {"multiplier", "of the equation in the combination whose Bernstein coefficients are positive"}};
  return facts;
}

std::map<std::string, std::string> published_in(const std::filesystem::path& path) {
  const std::string kind = kind_of_file(path);
  if (kind != "function" && kind != "system") return {};
  return load_problem(path).known.published;
}

}  // namespace

std::string IllustrateTask::summary() const {
  return "drawings of Bernstein polynomials, of the polytope, of what contractors do, and of construction "
         "plans";
}

std::vector<MethodInfo> IllustrateTask::methods() const {
  std::vector<MethodInfo> methods;
  for (const Illustration& drawing : drawings().entries())
    methods.push_back({drawing.name, drawing.summary, Promise::rigorous, 1, drawing.options});
  return methods;
}

std::vector<ValueInfo> IllustrateTask::values() const {
  std::vector<ValueInfo> values = {{"panels", "panels of the drawing"}};
  for (const ValueInfo& fact : published_facts()) {
    values.push_back(fact);
    values.push_back({"published_" + fact.name, "the same as the source prints it"});
  }
  values.push_back({"branch_changes", "of a path from one branch of a plan to another", "changes"});
  values.push_back({"crossings", "of t = 1 by a path", "crossings"});
  values.push_back({"simplices", "that a path passes", "simplices"});
  values.push_back({"figures", "that the branches of a plan have", "figures"});
  values.push_back({"widths", "of the interval after each reduction"});
  return values;
}

std::vector<std::string> IllustrateTask::problem_kinds() const {
  return {"function", "system", "constraint_system", "bernstein_basis", "bezier_curve"};
}

void IllustrateTask::check(const Job& job) const {
  const auto path = Corpus::standard().problem_path(job.problem);
  const std::string kind = kind_of_file(path);
  const std::vector<std::string> kinds = problem_kinds();
  if (std::ranges::find(kinds, kind) == kinds.end()) {
    throw InputError(path.string() + ": is of kind '" + kind + "', which cannot be drawn");
  }
  if (kind == "function" || kind == "system") {
    static_cast<void>(load_problem(path));
  } else if (kind == "constraint_system") {
    static_cast<void>(load_system(path.string()));
  } else {
    check_illustration(path);
  }
}

JobResult IllustrateTask::run(const Job& job, const std::stop_token&) const {
  const auto path = Corpus::standard().problem_path(job.problem);
  JobResult result;
  Drawn drawn = drawings().at(job.method).draw(path, job.options);
  result.values["panels"] = drawn.panels.size();
  for (const auto& [name, value] : drawn.values.items()) result.values[name] = value;
  for (const auto& [name, text] : published_in(path)) {
    if (drawn.values.contains(name)) result.values["published_" + name] = text;
  }
  result.artifact = {{"panels", std::move(drawn.panels)}};
  result.status = Status::complete;
  return result;
}

}  // namespace gcslab
