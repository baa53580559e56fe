#include "experiments/commands/describe_command.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <memory>
#include <optional>

#include "base/nearest_name.h"
#include "enclosure/bound_registry.h"
#include "experiments/commands/exit_code.h"
#include "experiments/corpus/corpus.h"
#include "experiments/corpus/problem.h"
#include "experiments/corpus/reference_table.h"
#include "experiments/tasks/job_result.h"
#include "experiments/tasks/registry.h"
#include "expression/printer.h"
#include "geometry/degrees_of_freedom.h"

namespace gcslab {
namespace {

Json options_json(const std::vector<OptionSpec>& options) {
  Json list = Json::array();
  for (const OptionSpec& option : options) {
    Json entry = {{"name", option.name},
                  {"meaning", option.meaning},
                  {"range", option.range_text()},
                  {"default", to_string(option.default_value)}};
    if (!option.unit.empty()) entry["unit"] = option.unit;
    list.push_back(entry);
  }
  return list;
}

/// A method that several tasks have is described once, with all of them.
std::optional<Json> method_json(const std::string& name) {
  Json result;
  for (const TaskEntry& entry : task_registry().entries()) {
    for (const MethodInfo& method : entry.task->methods()) {
      if (method.name != name) continue;
      if (result.is_null()) {
        result = {{"name", name},
                  {"what", "method"},
                  {"summary", method.summary},
                  {"promise", std::string(name_of(method.promise))},
                  {"version", method.version},
                  {"tasks", Json::array()},
                  {"options", options_json(method.options)}};
        if (const BoundVariant* bound = bound_registry().find(name)) result["applies_to"] = bound->applies_to;
      }
      result["tasks"].push_back(entry.name);
    }
  }
  return result.is_null() ? std::nullopt : std::optional(result);
}

std::optional<Json> task_json(const std::string& name) {
  const TaskEntry* entry = task_registry().find(name);
  if (entry == nullptr) return std::nullopt;
  Json values = Json::array();
  for (const ValueInfo& value : entry->task->values()) {
    values.push_back({{"name", value.name}, {"meaning", value.meaning}});
  }
  Json methods = Json::array();
  for (const MethodInfo& method : entry->task->methods()) methods.push_back(method.name);
  return Json{{"name", name},
              {"what", "task"},
              {"summary", entry->task->summary()},
              {"problem_kinds", entry->task->problem_kinds()},
              {"methods", methods},
              {"parameters", options_json(entry->task->parameters())},
              {"values", values}};
}

/// Figures of another program: by which methods, on which problems.
Json reference_json(const CorpusEntry& entry, Json result) {
  const ReferenceTable table = load_reference_table(entry.path);
  result["title"] = table.title;
  result["origin"] = table.origin;
  result["licence"] = table.licence;
  result["methods"] = table.methods;
  Json problems = Json::array();
  for (const ReferenceRun& run : table.runs) {
    if (std::ranges::find(problems, Json(run.problem)) == problems.end()) problems.push_back(run.problem);
  }
  result["problems"] = problems;
  if (!table.notes.empty()) result["notes"] = table.notes;
  return result;
}

/// What the equations of a constraint system came from.
void add_geometry(Json& result, const GeometricSource& source) {
  const auto names_of = [&](const std::vector<std::size_t>& points) {
    Json names = Json::array();
    for (const std::size_t point : points) names.push_back(source.system.objects[point].name);
    return names;
  };
  result["universe"] = source.system.universe == Universe::plane ? "2d" : "3d";
  for (const Sort sort : all_sorts()) {
    Json names = Json::array();
    for (const NamedObject& object : source.system.objects) {
      if (object.sort == sort) names.push_back(object.name);
    }
    result[name_of(sort) + "s"] = names;
  }
  result["constraints"] = Json::array();
  for (const Constraint& constraint : source.system.constraints)
    result["constraints"].push_back(source.system.describe(constraint));
  result["parameters"] = source.system.parameters;
  result["valuations"] = Json::array();
  for (const Valuation& valuation : source.system.valuations) result["valuations"].push_back(valuation.name);
  result["frame"] = names_of(source.frame);
  result["balance"] = balance_text(source.equations);
  result["structure"] = structure_text(source.system, structural_diagnosis(source.equations));
  const auto witness = witness_diagnosis(source.system, source.frame, source.equations);
  result["witness"] = witness ? witness_text(source.system, source.equations, *witness)
                              : "no figure found on which the boolean constraints hold";
}

Json problem_json(const CorpusEntry& entry) {
  const std::string kind = kind_of_file(entry.path);
  Json result = {{"name", entry.name}, {"what", "problem"}, {"kind", kind}, {"file", entry.path.string()}};
  if (kind == kReferenceTableKind) return reference_json(entry, result);
  if (std::ranges::find(function_kinds(), kind) == function_kinds().end()) return result;
  const Problem problem = load_problem(entry.path);
  result["title"] = problem.title;
  if (problem.geometry != nullptr) add_geometry(result, *problem.geometry);
  result["variables"] = problem.system.variables;
  Json equations = Json::array(), latex = Json::array(), box = Json::object();
  for (const Expression& equation : problem.system.equations) {
    equations.push_back(to_text(equation, problem.system.variables) + " = 0");
    latex.push_back(to_latex(equation, problem.system.variables) + " = 0");
  }
  for (std::size_t i = 0; i < problem.system.box.size(); ++i) {
    box[problem.system.variables[i]] = {problem.system.box[i].lower, problem.system.box[i].upper};
  }
  Json degrees = Json::array();
  for (const BoundTarget& target : problem.targets()) {
    degrees.push_back(target.is_polynomial() ? Json(target.polynomial().total_degree())
                                             : Json("transcendental"));
  }
  result["equations"] = equations;
  result["latex"] = latex;
  result["degrees"] = degrees;
  result["box"] = box;
  result["origin"] = problem.origin;
  result["licence"] = problem.licence;
  if (!problem.known.how.empty()) result["known"] = problem.known.how;
  if (!problem.notes.empty()) result["notes"] = problem.notes;
  return result;
}

const CorpusEntry* find_named(const std::vector<CorpusEntry>& entries, const std::string& name) {
  const auto found = std::ranges::find(entries, name, &CorpusEntry::name);
  return found == entries.end() ? nullptr : &*found;
}

Json file_json(const CorpusEntry& entry, const char* what) {
  const YamlNode file = YamlNode::load_file(entry.path);
  Json result = {{"name", entry.name}, {"what", what}, {"file", entry.path.string()}};
  for (const auto& [key, value] : file.entries()) {
    if (value.is_scalar()) result[key] = value.text();
    if (value.is_list() && !value.items().empty() && value.items().front().is_scalar())
      result[key] = value.texts();
  }
  return result;
}

Json description(const std::string& name) {
  if (const auto method = method_json(name)) return *method;
  if (const auto task = task_json(name)) return *task;
  const Corpus corpus = Corpus::standard();
  const auto problems = corpus.problems(), suites = corpus.suites(), configs = corpus.configs();
  if (const CorpusEntry* problem = find_named(problems, name)) return problem_json(*problem);
  const std::string suite_name = name.starts_with("suite:") ? name.substr(6) : name;
  if (const CorpusEntry* suite = find_named(suites, suite_name)) return file_json(*suite, "suite");
  if (const CorpusEntry* config = find_named(configs, name)) return file_json(*config, "config");
  std::vector<std::string> known;
  for (const TaskEntry& entry : task_registry().entries()) {
    known.push_back(entry.name);
    for (const MethodInfo& method : entry.task->methods()) known.push_back(method.name);
  }
  for (const auto* entries : {&problems, &suites, &configs}) {
    for (const CorpusEntry& entry : *entries) known.push_back(entry.name);
  }
  const auto nearest = nearest_name(name, known);
  throw InputError("nothing is named '" + name + "'" +
                   (nearest ? " (did you mean '" + *nearest + "'?)" : "") +
                   "; see gcslab list problems, methods, suites, configs");
}

void print_value(const Json& value, const std::string& indent) {
  if (value.is_array() && !value.empty() && value.front().is_object()) {
    for (const Json& item : value) {
      fmt::print("\n{}{}", indent, item.at("name").get<std::string>());
      if (item.contains("default")) {
        fmt::print(" = {}", item.at("default").get<std::string>());
        if (item.contains("unit")) fmt::print(" {}", item.at("unit").get<std::string>());
        fmt::print("   ({})", item.at("range").get<std::string>());
      }
      fmt::print("\n{}    {}", indent, item.at("meaning").get<std::string>());
    }
    fmt::print("\n");
  } else if (value.is_array()) {
    std::vector<std::string> texts;
    for (const Json& item : value) texts.push_back(item.is_string() ? item.get<std::string>() : item.dump());
    fmt::print(" {}\n", fmt::join(texts, ", "));
  } else {
    fmt::print(" {}\n", value.is_string() ? value.get<std::string>() : value.dump());
  }
}

struct Settings {
  std::string name;
  bool json = false;
};

}  // namespace

void add_describe_command(CLI::App& app, int& exit_code) {
  auto settings = std::make_shared<Settings>();
  CLI::App* command = app.add_subcommand("describe", "Describe a method, task, problem, suite or config");
  command->add_option("name", settings->name, "a name that `gcslab list` prints, or a task")->required();
  command->add_flag("--json", settings->json, "machine-readable");
  command->callback([settings, &exit_code] {
    const Json about = description(settings->name);
    if (settings->json) {
      fmt::print("{}\n", about.dump(2));
    } else {
      for (const auto& [key, value] : about.items()) {
        if ((value.is_array() || value.is_object()) && value.empty()) continue;
        fmt::print("{}:", key);
        print_value(value, "  ");
      }
    }
    exit_code = kDone;
  });
}

}  // namespace gcslab
