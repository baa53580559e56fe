#include "experiments/corpus/problem.h"

#include <algorithm>
#include <fmt/format.h>

#include "base/atomic_file.h"
#include "base/content_hash.h"
#include "base/nearest_name.h"
#include "base/yaml_reader.h"
#include "experiments/corpus/generated_figure.h"
#include "experiments/corpus/generated_system.h"
#include "expression/printer.h"
#include "expression/system_formats.h"
#include "geometry/constraint_system_reader.h"

namespace gcslab {
namespace {

struct Shape {
  std::string kind;
  std::size_t variables;  ///< 0: any number
  std::size_t equations;  ///< 0: any number
};

const std::vector<Shape>& shapes() {
  static const std::vector<Shape> all = {{"curve", 2, 1},    {"surface", 3, 1}, {"space_curve", 3, 2},
                                         {"function", 0, 1}, {"system", 0, 0},  {"constraint_system", 0, 0}};
  return all;
}

std::string optional_text(const YamlNode& node, std::string_view key) {
  const auto value = node.find(key);
  return value ? value->text() : "";
}

std::string required_text(const YamlNode& node, std::string_view key) {
  const YamlNode value = node.at(key);
  if (value.text().empty()) value.fail("is empty");
  return value.text();
}

std::vector<std::vector<Rational>> read_points(const YamlNode& known, std::string_view key,
                                               std::size_t variables) {
  std::vector<std::vector<Rational>> points;
  const auto list = known.find(key);
  if (!list) return points;
  for (const YamlNode& item : list->items()) {
    std::vector<Rational> point;
    for (const YamlNode& coordinate : item.items()) {
      try {
        point.push_back(rational_from_text(coordinate.text()));
      } catch (const InputError& error) {
        coordinate.fail(error.what());
      }
    }
    if (point.size() != variables) item.fail("must have one coordinate a variable");
    points.push_back(std::move(point));
  }
  return points;
}

KnownFacts read_known(const YamlNode& problem, std::size_t variables) {
  const auto known = problem.find("known");
  if (!known) return {};
  known->allow_keys({"points", "singular", "real_solutions", "published", "how"});
  KnownFacts facts;
  facts.points = read_points(*known, "points", variables);
  facts.singular = read_points(*known, "singular", variables);
  facts.how = required_text(*known, "how");
  if (const auto published = known->find("published")) {
    for (const auto& [name, value] : published->entries()) facts.published[name] = value.text();
  }
  if (const auto count = known->find("real_solutions")) facts.real_solutions = count->integer();
  return facts;
}

void check_shape(const YamlNode& file, const Problem& problem) {
  const auto shape = std::ranges::find(shapes(), problem.kind, &Shape::kind);
  const bool variables_fit = shape->variables == 0 || problem.system.variables.size() == shape->variables;
  const bool equations_fit = shape->equations == 0 || problem.system.equations.size() == shape->equations;
  if (!variables_fit || !equations_fit) {
    file.at("kind").fail("is " + problem.kind + ", which takes " +
                         (shape->variables == 0 ? "any number of" : std::to_string(shape->variables)) +
                         " variables and " + std::to_string(shape->equations) + " equation(s)");
  }
}

}  // namespace

std::vector<BoundTarget> Problem::targets(const std::vector<Expression>& functions) const {
  std::vector<BoundTarget> result;
  for (const Expression& function : functions) {
    result.emplace_back(system.graph, function, static_cast<int>(system.variables.size()));
  }
  return result;
}

void check_known_points(const Problem& problem) {
  const auto targets = problem.targets();
  for (const auto& point : problem.known.points) {
    std::string text;
    for (const Rational& coordinate : point) text += (text.empty() ? "" : ", ") + coordinate.get_str();
    for (const BoundTarget& target : targets) {
      if (target.is_polynomial() && target.polynomial().evaluate(point) != 0) {
        throw InputError(problem.name + ": the known point (" + text + ") does not satisfy the equations");
      }
    }
    for (std::size_t i = 0; i < point.size(); ++i) {
      const Interval& side = problem.system.box[i];
      if (is_bounded(side) &&
          (point[i] < rational_from_double(side.lower) || point[i] > rational_from_double(side.upper))) {
        throw InputError(problem.name + ": the known point (" + text + ") lies outside the box");
      }
    }
  }
}

const std::vector<std::string>& function_kinds() {
  static const std::vector<std::string> kinds = [] {
    std::vector<std::string> names;
    for (const Shape& shape : shapes()) names.push_back(shape.kind);
    names.emplace_back("polynomial_family");
    return names;
  }();
  return kinds;
}

std::string kind_of_file(const std::filesystem::path& path) {
  if (format_of_file(path) != nullptr) return "system";
  return YamlNode::load_file(path).at("kind").text();
}

std::string problem_content_hash(const std::filesystem::path& path) {
  const std::string kind = kind_of_file(path);
  const bool has_equations = std::ranges::find(function_kinds(), kind) != function_kinds().end();
  if (!has_equations || kind == "polynomial_family" || kind == "constraint_system")
    return content_hash(read_file(path));
  const Problem problem = load_problem(path);
  const EquationSystem& system = problem.system;
  std::string text = kind;
  for (const std::string& variable : system.variables) text += "\n" + variable;
  for (const Expression& equation : system.equations) text += "\n0 = " + to_text(equation, system.variables);
  for (const Expression& inequality : system.inequalities)
    text += "\n0 >= " + to_text(inequality, system.variables);
  for (const Interval& side : system.box) text += fmt::format("\n[{:a}, {:a}]", side.lower, side.upper);
  for (const auto& [name, value] : problem.known.published) text += fmt::format("\n{} = {}", name, value);
  return content_hash(text);
}

namespace {

/// A system in another format, which says nothing but the system.
Problem load_foreign(const std::filesystem::path& path) {
  Problem problem;
  problem.kind = "system";
  problem.name = path.stem().string();
  problem.system = read_system_file(path);
  return problem;
}

void refuse_valuation(const std::filesystem::path& path, const std::string& valuation) {
  if (!valuation.empty())
    throw InputError(path.string() + ": has no valuations, and so none named '" + valuation + "'");
}

bool is_constraint_system(const YamlNode& file) {
  const auto kind = file.find("kind");
  return kind && kind->is_scalar() && kind->text() == "constraint_system";
}

void allow_keys(const YamlNode& file) {
  std::vector<std::string> keys = {"kind", "name", "title", "origin", "licence", "known", "notes"};
  const std::vector<std::string> of_systems = {"variables", "equations", "generator", "inequalities", "box"};
  const std::vector<std::string>& others = is_constraint_system(file) ? constraint_system_keys() : of_systems;
  keys.insert(keys.end(), others.begin(), others.end());
  if (is_constraint_system(file)) keys.insert(keys.end(), {"generator", "box"});
  file.allow_keys(keys);
}

/// The entry of that key for the valuation, where there is one.
std::optional<std::int64_t> count_of_valuation(const YamlNode& known, std::string_view key,
                                               const ConstraintSystem& system, const std::string& valuation) {
  const auto counts = known.find(key);
  if (!counts) return std::nullopt;
  for (const auto& [name, count] : counts->entries()) {
    if (std::ranges::find(system.valuations, name, &Valuation::name) == system.valuations.end())
      count.fail("is of no valuation: none is named '" + name + "'");
  }
  const auto count = counts->find(valuation);
  return count ? std::optional(count->integer()) : std::nullopt;
}

/// Counts of solutions: in the frame with the signs free, and modulo all isometries.
KnownFacts read_known_figures(const YamlNode& file, const GeometricSource& source) {
  const auto known = file.find("known");
  if (!known) return {};
  known->allow_keys({"in_frame", "classes", "how"});
  KnownFacts facts;
  facts.how = required_text(*known, "how");
  facts.real_solutions = count_of_valuation(*known, "in_frame", source.system, source.valuation);
  facts.classes = count_of_valuation(*known, "classes", source.system, source.valuation);
  return facts;
}

/// Intervals for some unknowns, which narrow the box that holds all solutions.
void narrow_box(const YamlNode& node, EquationSystem& system) {
  node.allow_keys(system.variables);
  std::vector<std::string> names;
  for (const auto& [name, interval] : node.entries()) names.push_back(name);
  const Box given = read_box(node, names);
  for (std::size_t k = 0; k < names.size(); ++k) {
    const auto variable = std::ranges::find(system.variables, names[k]) - system.variables.begin();
    Interval& side = system.box[static_cast<std::size_t>(variable)];
    side = intersection(side, given[k]);
    if (is_empty(side)) node.at(names[k]).fail("leaves nothing: the constraints keep it elsewhere");
  }
}

void read_geometry(const YamlNode& file, const std::string& valuation, Problem& problem) {
  auto source = std::make_shared<GeometricSource>();
  const auto generator = file.find("generator");
  source->system = generator ? read_generated_figure(file, *generator) : read_constraint_system(file);
  const Valuation& chosen = source->system.valuation(valuation);
  source->valuation = chosen.name;
  source->frame = frame_of(source->system);
  source->equations = geometric_equations(source->system, source->frame);
  problem.system = equation_system(source->equations, source->system, source->frame, chosen);
  if (const auto box = file.find("box")) narrow_box(*box, problem.system);
  problem.known = read_known_figures(file, *source);
  problem.geometry = std::move(source);
}

}  // namespace

Problem load_problem(const std::filesystem::path& path, const std::string& valuation) {
  if (format_of_file(path) != nullptr) {
    refuse_valuation(path, valuation);
    return load_foreign(path);
  }
  const YamlNode file = YamlNode::load_file(path);
  allow_keys(file);
  Problem problem;
  problem.kind = file.at("kind").text();
  if (std::ranges::find(function_kinds(), problem.kind) == function_kinds().end()) {
    file.at("kind").fail(unknown_name_message("kind", problem.kind, function_kinds()));
  }
  problem.name = required_text(file, "name");
  problem.title = optional_text(file, "title");
  problem.origin = required_text(file, "origin");
  problem.licence = required_text(file, "licence");
  const auto notes = file.find("notes");  // free: any shape
  if (notes && notes->is_scalar()) problem.notes = notes->text();
  if (problem.kind == "constraint_system") {
    read_geometry(file, valuation, problem);
    return problem;
  }
  refuse_valuation(path, valuation);
  if (problem.kind == "polynomial_family") return problem;  // its members are made by the tasks
  const auto generator = file.find("generator");
  problem.system = generator ? read_generated_system(file, *generator) : read_equation_system(file);
  problem.known = read_known(file, problem.system.variables.size());
  check_shape(file, problem);
  return problem;
}

}  // namespace gcslab
