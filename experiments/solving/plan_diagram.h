#pragma once

// A construction plan by names: what is drawn of it, and what results say of its steps.

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "construction/plan.h"

namespace gcslab {

struct PlanDiagram {
  /// A locus of a point, or a constraint that is not used.
  struct Locus {
    std::string kind;             ///< "sphere", or the word of the constraint
    std::vector<std::string> of;  ///< the other points of a locus, all of a constraint
    std::string value{};          ///< parameter or guide; empty: none
    bool is_guide = false;
  };
  struct Step {
    std::string object;
    std::size_t places = 1;  ///< at most
    std::vector<Locus> loci;
  };
  std::vector<Step> steps;
  std::vector<Locus> removed;
};

PlanDiagram plan_diagram(const Plan& plan, const ConstraintSystem& system);

/// {"steps": [{"object", "places", "loci": [{"kind", "of", "value", "guide"}]}], "removed_constraints":
/// [{"kind", "of", "value"}]}; "value" and "guide" where there is one.
nlohmann::ordered_json to_json(const PlanDiagram& diagram);
/// The inverse; other keys may stand beside these. Throws InputError when the JSON is no such thing, or a
/// step uses points that no earlier one places.
PlanDiagram plan_diagram_from_json(const nlohmann::ordered_json& json);

}  // namespace gcslab
