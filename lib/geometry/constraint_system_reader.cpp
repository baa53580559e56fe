#include "geometry/constraint_system_reader.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/nearest_name.h"
#include "expression/equation_system.h"
#include "expression/parser.h"
#include "geometry/object_reader.h"
#include "geometry/valuation_reader.h"

namespace gcslab {
namespace {

std::size_t object_named(const YamlNode& node, const ConstraintSystem& system) {
  const std::string name = node.text();
  const auto found = std::ranges::find(system.objects, name, &NamedObject::name);
  const char* what = system.points() == system.objects.size() ? "point" : "object";
  if (found == system.objects.end()) node.fail(unknown_name_message(what, name, system.names()));
  return static_cast<std::size_t>(found - system.objects.begin());
}

std::vector<std::size_t> objects_named(const YamlNode& node, const ConstraintSystem& system) {
  std::vector<std::size_t> result;
  for (const YamlNode& item : node.items()) result.push_back(object_named(item, system));
  return result;
}

/// With `in_pairs`, an object may come again in another pair.
void refuse_repeated(const YamlNode& node, const std::vector<std::size_t>& objects,
                     const ConstraintSystem& system, bool in_pairs = false) {
  const std::vector<YamlNode> items = node.items();
  for (std::size_t k = 0; k < objects.size(); ++k) {
    const auto last = objects.begin() + static_cast<std::ptrdiff_t>(k);
    const auto first = in_pairs ? last - static_cast<std::ptrdiff_t>(k % 2) : objects.begin();
    if (std::find(first, last, objects[k]) == last) continue;
    const auto& [name, sort] = system.objects[objects[k]];
    items[k].fail("names the " + name_of(sort) + " '" + name + "' twice");
  }
}

Universe read_universe(const YamlNode& node) {
  const std::string text = node.text();
  if (text != "2d" && text != "3d") node.fail("is '" + text + "'; expected 2d or 3d");
  return text == "2d" ? Universe::plane : Universe::space;
}

/// The names under the key of a sort.
void read_objects(const YamlNode& problem, Sort sort, ConstraintSystem& system) {
  const auto node = problem.find(name_of(sort) + "s");
  if (!node) return;
  if (!exists_in(sort, system.universe)) node->fail("are for universe: 3d; the universe here is the plane");
  const std::vector<std::string> names = read_variables(*node);
  for (std::size_t k = 0; k < names.size(); ++k) {
    const auto known = std::ranges::find(system.objects, names[k], &NamedObject::name);
    if (known != system.objects.end())
      node->items()[k].fail("names the " + name_of(known->sort) + " '" + names[k] + "' again");
    system.objects.push_back({names[k], sort});
  }
}

/// The one word of the item that is a constraint.
std::string word_of(const YamlNode& item) {
  const std::vector<std::string> others = {"parameter", "interpretation"};
  std::string word;
  for (const auto& [key, value] : item.entries()) {
    if (std::ranges::find(others, key) != others.end()) continue;
    if (constraint_registry().kinds(key).empty())
      value.fail(unknown_name_message("constraint", key, constraint_registry().names()));
    if (!word.empty()) value.fail("is a second constraint, '" + key + "' beside '" + word + "'");
    word = key;
  }
  if (word.empty()) item.fail("is no constraint; expected for example {distance: [P0, P1], parameter: h0}");
  return word;
}

/// "constraint 3, distance P0 c", before its kind is known.
std::string name_before_kind(const std::string& word, const std::vector<std::size_t>& objects,
                             const ConstraintSystem& system) {
  std::string text = fmt::format("constraint {}, {}", system.constraints.size() + 1, word);
  for (const std::size_t object : objects) text += " " + system.objects[object].name;
  return text;
}

/// The kind of that word which is about these objects, whose order becomes that of its sorts.
const ConstraintKind& kind_for(const YamlNode& node, const std::string& word,
                               std::vector<std::size_t>& objects, const ConstraintSystem& system) {
  const auto sort_of = [&](std::size_t object) { return system.objects[object].sort; };
  const std::string name = name_before_kind(word, objects, system);
  std::ranges::stable_sort(objects, {}, sort_of);
  std::vector<Sort> sorts;
  for (const std::size_t object : objects) sorts.push_back(sort_of(object));
  std::vector<std::string> takes;
  for (const ConstraintKind* kind : constraint_registry().kinds(word)) {
    const bool is_here = kind->takes(system.universe);
    if (kind->sorts == sorts && !is_here) node.fail(name + ": is for the other universe");
    if (kind->sorts == sorts) return *kind;
    if (is_here) takes.push_back(fmt::format("{} ({})", text_of(kind->sorts), kind->summary));
  }
  if (takes.empty()) node.fail(name + ": is for the other universe");
  node.fail(fmt::format("{}: takes {}; not {}", name, fmt::join(takes, ", or "), text_of(sorts)));
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
  const std::string word = word_of(item);
  const YamlNode node = item.at(word);
  std::vector<std::size_t> objects = objects_named(node, system);
  const std::vector<std::size_t> as_named = objects;
  const ConstraintKind& kind = kind_for(node, word, objects, system);
  refuse_repeated(node, as_named, system, kind.is_about_pairs);
  system.constraints.push_back({&kind, std::move(objects), std::nullopt});
  const std::string name = system.describe(system.constraints.back());
  Constraint& added = system.constraints.back();
  added.interpretation = read_interpretation(item, kind);
  const auto parameter = item.find("parameter");
  if (parameter && !kind.is_metric()) parameter->fail(name + ": has no parameter");
  if (!parameter && kind.is_metric()) item.fail(name + ": needs a parameter");
  if (parameter) added.parameter = parameter_named(*parameter, system);
}

void read_frame(const YamlNode& node, ConstraintSystem& system) {
  if (node.is_scalar() && node.text() == "none") {
    system.frame = Frame();
    return;
  }
  Frame frame = objects_named(node, system);
  for (std::size_t k = 0; k < frame.size(); ++k) {
    const auto& [name, sort] = system.objects[frame[k]];
    if (sort != Sort::point)
      node.items()[k].fail("names the " + name_of(sort) + " '" + name + "'; a frame is of points");
  }
  refuse_repeated(node, frame, system);
  if (frame.size() != dimension(system.universe))
    node.fail(fmt::format("names {} points; expected {}: the origin, one on the x axis{}, or none",
                          frame.size(), dimension(system.universe),
                          system.universe == Universe::space ? ", one in the xy plane" : ""));
  system.frame = std::move(frame);
}

}  // namespace

const std::vector<std::string>& constraint_system_keys() {
  static const std::vector<std::string> keys = {"universe", "points",      "lines",      "planes", "circles",
                                                "spheres",  "constraints", "valuations", "sketch", "frame"};
  return keys;
}

void read_sketch(const YamlNode& node, ConstraintSystem& system) {
  if (const auto random = node.find("random")) {
    node.allow_keys({"random"});
    const std::int64_t seed = random->integer();
    if (seed < 0) random->fail("is negative; a seed is a whole number from 0 on");
    system.random_sketch = static_cast<std::uint64_t>(seed);
    system.sketch.reset();
    return;
  }
  node.allow_keys(system.names());
  Figure figure;
  for (const auto& [name, sort] : system.objects)
    figure.push_back(read_object(node.at(name), sort, system.universe));
  system.sketch = std::move(figure);
}

ConstraintSystem read_constraint_system(const YamlNode& problem) {
  ConstraintSystem system;
  system.universe = read_universe(problem.at("universe"));
  for (const Sort sort : all_sorts()) read_objects(problem, sort, system);
  if (system.objects.empty()) problem.fail("names no object; expected for example points: [P0, P1]");
  const YamlNode constraints = problem.at("constraints");
  for (const YamlNode& item : constraints.items()) read_constraint(item, system);
  if (system.constraints.empty()) constraints.fail("lists no constraint");
  const YamlNode valuations = problem.at("valuations");
  for (const auto& [name, value] : valuations.entries())
    system.valuations.push_back(read_valuation(name, value, system));
  if (system.valuations.empty()) valuations.fail("names no valuation");
  if (const auto sketch = problem.find("sketch")) read_sketch(*sketch, system);
  if (const auto frame = problem.find("frame")) read_frame(*frame, system);
  return system;
}

}  // namespace gcslab
