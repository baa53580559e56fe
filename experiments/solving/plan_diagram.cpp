#include "experiments/solving/plan_diagram.h"

#include <algorithm>
#include <set>

#include "base/error.h"

namespace gcslab {
namespace {

using Json = nlohmann::ordered_json;
using Part = PlanDiagram::Locus;

Part constraint_of(const Constraint& constraint, const ConstraintSystem& system) {
  Part result{constraint.kind->name, {}};
  for (const std::size_t object : constraint.objects) result.of.push_back(system.objects[object].name);
  if (constraint.parameter) result.value = system.parameters[*constraint.parameter];
  return result;
}

Part locus_of(const LocusSource& source, const Plan& plan, const ConstraintSystem& system,
              std::size_t point) {
  if (source.guide) {
    const std::string& centre = system.objects[plan.guides[*source.guide].centre].name;
    return {"sphere", {centre}, "k" + std::to_string(*source.guide), true};
  }
  Part result = constraint_of(system.constraints[*source.constraint], system);
  if (result.kind == "distance") result.kind = "sphere";
  std::erase(result.of, system.objects[point].name);
  return result;
}

Json locus_json(const Part& locus) {
  Json json = {{"kind", locus.kind}, {"of", locus.of}};
  if (!locus.value.empty()) json["value"] = locus.value;
  if (locus.is_guide) json["guide"] = true;
  return json;
}

Part locus_from(const Json& json, const std::set<std::string>& placed) {
  Part locus{json.at("kind").get<std::string>(), json.at("of").get<std::vector<std::string>>(),
             json.value("value", ""), json.value("guide", false)};
  for (const std::string& name : locus.of) {
    if (!placed.contains(name)) throw InputError("a plan uses " + name + ", which no step before places");
  }
  return locus;
}

}  // namespace

PlanDiagram plan_diagram(const Plan& plan, const ConstraintSystem& system) {
  PlanDiagram diagram;
  for (const PlanStep& step : plan.steps) {
    diagram.steps.push_back({system.objects[step.point].name, step.choice ? 2U : 1U, {}});
    for (const LocusSource& source : step.loci)
      diagram.steps.back().loci.push_back(locus_of(source, plan, system, step.point));
  }
  for (const std::size_t c : plan.removed)
    diagram.removed.push_back(constraint_of(system.constraints[c], system));
  return diagram;
}

Json to_json(const PlanDiagram& diagram) {
  Json steps = Json::array(), removed = Json::array();
  for (const PlanDiagram::Step& step : diagram.steps) {
    Json loci = Json::array();
    for (const Part& locus : step.loci) loci.push_back(locus_json(locus));
    steps.push_back({{"object", step.object}, {"places", step.places}, {"loci", std::move(loci)}});
  }
  for (const Part& constraint : diagram.removed) removed.push_back(locus_json(constraint));
  return {{"steps", std::move(steps)}, {"removed_constraints", std::move(removed)}};
}

PlanDiagram plan_diagram_from_json(const Json& json) {
  try {
    PlanDiagram diagram;
    std::set<std::string> placed;
    for (const Json& entry : json.at("steps")) {
      PlanDiagram::Step step{
          entry.at("object").get<std::string>(), entry.at("places").get<std::size_t>(), {}};
      for (const Json& locus : entry.at("loci")) step.loci.push_back(locus_from(locus, placed));
      if (!placed.insert(step.object).second) throw InputError("a plan places " + step.object + " twice");
      diagram.steps.push_back(std::move(step));
    }
    for (const Json& constraint : json.at("removed_constraints"))
      diagram.removed.push_back(locus_from(constraint, placed));
    return diagram;
  } catch (const nlohmann::json::exception& error) {
    throw InputError(std::string("a plan is not as it should be: ") + error.what());
  }
}

}  // namespace gcslab
