#include "expression/json_writer.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "expression/printer.h"

namespace gcslab {

std::string write_json(const EquationSystem& system) {
  nlohmann::ordered_json json;
  json["format"] = "gcslab-system";
  json["variables"] = system.variables;
  json["equations"] = nlohmann::ordered_json::array();
  for (const Expression& equation : system.equations) {
    json["equations"].push_back(to_text(equation, system.variables));
  }
  json["inequalities"] = nlohmann::ordered_json::array();
  for (const Expression& inequality : system.inequalities) {
    json["inequalities"].push_back(to_text(inequality, system.variables));
  }
  json["box"] = nlohmann::ordered_json::object();
  for (std::size_t i = 0; i < system.variables.size(); ++i) {
    const Interval& side = system.box[i];
    json["box"][system.variables[i]] =
        nlohmann::ordered_json::array({fmt::format("{:a}", side.lower), fmt::format("{:a}", side.upper)});
  }
  return json.dump(2) + "\n";
}

}  // namespace gcslab
