#include "geometry/valuation_reader.h"

#include <fmt/format.h>

#include "expression/constant_enclosure.h"
#include "expression/parser.h"

namespace gcslab {
namespace {

/// "1.3", "sqrt(2)", "30 deg".
Expression value_of(const YamlNode& node, ExpressionGraph& graph) {
  std::string text = node.text();
  const std::string unit = "deg";
  const bool is_in_degrees = text.size() > unit.size() && text.ends_with(unit);
  if (is_in_degrees) text.resize(text.size() - unit.size());
  try {
    const Expression value = parse_expression(graph, text, {});
    if (is_empty(constant_enclosure(value))) throw InputError("\"" + text + "\" is not defined");
    return is_in_degrees ? value * graph.pi() / graph.constant(180) : value;
  } catch (const InputError& error) {
    throw InputError(node.where(), error.what());
  }
}

void check_possible(const YamlNode& node, const ConstraintSystem& system, std::size_t parameter,
                    Expression value) {
  for (const Constraint& constraint : system.constraints) {
    if (constraint.parameter != parameter) continue;
    const Interval possible = constraint.kind->possible;
    if (disjoint(constant_enclosure(value), possible)) {
      node.fail(fmt::format("{}: {} = {} is impossible: {} lies between {:g} and {:g}",
                            system.describe(constraint), system.parameters[parameter], node.text(),
                            constraint.kind->summary, possible.lower, possible.upper));
    }
  }
}

}  // namespace

Valuation read_valuation(const std::string& name, const YamlNode& node, const ConstraintSystem& system) {
  node.allow_keys(system.parameters);
  Valuation valuation{name, {}};
  for (std::size_t p = 0; p < system.parameters.size(); ++p) {
    const YamlNode value = node.at(system.parameters[p]);
    valuation.values.push_back(value_of(value, *system.values_graph));
    check_possible(value, system, p, valuation.values.back());
  }
  return valuation;
}

}  // namespace gcslab
