#include "geometry/constraint_system_reader.h"

#include <algorithm>
#include <fmt/format.h>

#include "base/nearest_name.h"
#include "expression/constant_enclosure.h"
#include "expression/equation_system.h"
#include "expression/parser.h"

namespace gcslab {
namespace {

std::size_t point_named(const YamlNode& node, const ConstraintSystem& system) {
  const std::string name = node.text();
  const auto found = std::ranges::find(system.points, name);
  if (found == system.points.end()) node.fail(unknown_name_message("point", name, system.points));
  return static_cast<std::size_t>(found - system.points.begin());
}

/// With `in_pairs`, a point may come again in another pair.
std::vector<std::size_t> points_named(const YamlNode& node, const ConstraintSystem& system,
                                      bool in_pairs = false) {
  std::vector<std::size_t> result;
  for (const YamlNode& item : node.items()) {
    const std::size_t point = point_named(item, system);
    const auto first =
        in_pairs ? result.end() - static_cast<std::ptrdiff_t>(result.size() % 2) : result.begin();
    if (std::find(first, result.end(), point) != result.end())
      item.fail("names the point '" + system.points[point] + "' twice");
    result.push_back(point);
  }
  return result;
}

Universe read_universe(const YamlNode& node) {
  const std::string text = node.text();
  if (text != "2d" && text != "3d") node.fail("is '" + text + "'; expected 2d or 3d");
  return text == "2d" ? Universe::plane : Universe::space;
}

const ConstraintKind& kind_of(const YamlNode& item) {
  const std::vector<std::string> others = {"parameter", "interpretation"};
  const ConstraintKind* kind = nullptr;
  for (const auto& [key, value] : item.entries()) {
    if (std::ranges::find(others, key) != others.end()) continue;
    const ConstraintKind* found = constraint_registry().find(key);
    if (found == nullptr) value.fail(unknown_name_message("constraint", key, constraint_registry().names()));
    if (kind != nullptr) value.fail("is a second constraint, '" + key + "' beside '" + kind->name + "'");
    kind = found;
  }
  if (kind == nullptr)
    item.fail("is no constraint; expected for example {distance: [P0, P1], parameter: h0}");
  return *kind;
}

std::size_t read_interpretation(const YamlNode& item, const ConstraintKind& kind) {
  const auto chosen = item.find("interpretation");
  if (!chosen) return 0;
  const auto found = std::ranges::find(kind.interpretations, chosen->text(), &Interpretation::name);
  if (found != kind.interpretations.end())
    return static_cast<std::size_t>(found - kind.interpretations.begin());
  std::vector<std::string> known;
  for (const Interpretation& each : kind.interpretations) known.push_back(each.name);
  chosen->fail(unknown_name_message("interpretation of " + kind.name, chosen->text(), known));
}

/// The number of the parameter, which several constraints may share.
std::size_t parameter_named(const YamlNode& node, ConstraintSystem& system) {
  const std::string name = node.text();
  if (!is_variable_name(name))
    node.fail("is '" + name + "'; a parameter is letters, digits and _, no function");
  const auto found = std::ranges::find(system.parameters, name);
  const auto number = static_cast<std::size_t>(found - system.parameters.begin());
  if (found == system.parameters.end()) system.parameters.push_back(name);
  return number;
}

void read_constraint(const YamlNode& item, ConstraintSystem& system) {
  Constraint constraint{&kind_of(item), {}, std::nullopt};
  const ConstraintKind& kind = *constraint.kind;
  const YamlNode points = item.at(kind.name);
  constraint.points = points_named(points, system, kind.is_about_pairs);
  system.constraints.push_back(constraint);
  const std::string name = system.describe(system.constraints.back());
  if (!kind.takes(system.universe)) points.fail(name + ": is for the other universe");
  if (constraint.points.size() != kind.points)
    points.fail(fmt::format("{}: takes {} points ({})", name, kind.points, kind.summary));
  Constraint& added = system.constraints.back();
  added.interpretation = read_interpretation(item, kind);
  const auto parameter = item.find("parameter");
  if (parameter && !kind.is_metric()) parameter->fail(name + ": has no parameter");
  if (!parameter && kind.is_metric()) item.fail(name + ": needs a parameter");
  if (parameter) added.parameter = parameter_named(*parameter, system);
}

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

void read_valuation(const std::string& name, const YamlNode& node, ConstraintSystem& system) {
  node.allow_keys(system.parameters);
  Valuation valuation{name, {}};
  for (std::size_t p = 0; p < system.parameters.size(); ++p) {
    const YamlNode value = node.at(system.parameters[p]);
    valuation.values.push_back(value_of(value, *system.values_graph));
    check_possible(value, system, p, valuation.values.back());
  }
  system.valuations.push_back(std::move(valuation));
}

std::vector<double> read_point(const YamlNode& node, Universe universe) {
  std::vector<double> coordinates;
  for (const YamlNode& item : node.items()) coordinates.push_back(item.real());
  if (coordinates.size() != dimension(universe))
    node.fail(fmt::format("has {} coordinates; expected {}", coordinates.size(), dimension(universe)));
  return coordinates;
}

void read_sketch(const YamlNode& node, ConstraintSystem& system) {
  if (const auto random = node.find("random")) {
    node.allow_keys({"random"});
    const std::int64_t seed = random->integer();
    if (seed < 0) random->fail("is negative; a seed is a whole number from 0 on");
    system.random_sketch = static_cast<std::uint64_t>(seed);
    return;
  }
  node.allow_keys(system.points);
  Figure figure;
  for (const std::string& point : system.points)
    figure.push_back(read_point(node.at(point), system.universe));
  system.sketch = std::move(figure);
}

void read_frame(const YamlNode& node, ConstraintSystem& system) {
  if (node.is_scalar() && node.text() == "none") {
    system.frame = Frame();
    return;
  }
  Frame frame = points_named(node, system);
  if (frame.size() != dimension(system.universe))
    node.fail(fmt::format("names {} points; expected {}: the origin, one on the x axis{}, or none",
                          frame.size(), dimension(system.universe),
                          system.universe == Universe::space ? ", one in the xy plane" : ""));
  system.frame = std::move(frame);
}

}  // namespace

const std::vector<std::string>& constraint_system_keys() {
  static const std::vector<std::string> keys = {"universe",   "points", "constraints",
                                                "valuations", "sketch", "frame"};
  return keys;
}

ConstraintSystem read_constraint_system(const YamlNode& problem) {
  ConstraintSystem system;
  system.universe = read_universe(problem.at("universe"));
  system.points = read_variables(problem.at("points"));
  const YamlNode constraints = problem.at("constraints");
  for (const YamlNode& item : constraints.items()) read_constraint(item, system);
  if (system.constraints.empty()) constraints.fail("lists no constraint");
  const YamlNode valuations = problem.at("valuations");
  for (const auto& [name, value] : valuations.entries()) read_valuation(name, value, system);
  if (system.valuations.empty()) valuations.fail("names no valuation");
  if (const auto sketch = problem.find("sketch")) read_sketch(*sketch, system);
  if (const auto frame = problem.find("frame")) read_frame(*frame, system);
  return system;
}

}  // namespace gcslab
