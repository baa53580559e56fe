#include "experiments/commands/validate_command.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <fmt/format.h>
#include <memory>

#include "base/yaml_reader.h"
#include "experiments/commands/exit_code.h"
#include "experiments/corpus/corpus.h"
#include "experiments/corpus/problem.h"
#include "experiments/corpus/reference_table.h"
#include "experiments/corpus/system_family.h"
#include "experiments/runner/experiment_config.h"
#include "experiments/tasks/catalogue.h"
#include "experiments/tasks/illustrate_task.h"
#include "expression/system_formats.h"

namespace gcslab {
namespace {

/// What the file is, when it is good. Throws InputError when it is not.
std::string checked_kind(const std::string& file, const Catalogue& catalogue) {
  if (format_of_file(file) != nullptr) {
    const EquationSystem system = load_problem(file).system;
    return fmt::format("system of {} equations in {} variables", system.equations.size(),
                       system.variables.size());
  }
  const YamlNode root = YamlNode::load_file(file);
  if (root.find("experiment")) {
    const ExperimentConfig config = load_experiment(file, catalogue);
    return fmt::format("config of {} problems and {} methods", config.problems.size(), config.methods.size());
  }
  if (root.find("suite"))
    return fmt::format("suite of {} problems", Corpus::standard().suite_members(file).size());
  const std::string kind = root.at("kind").text();
  if (kind == kSystemFamilyKind) {
    check_system_family(file);
    return "family of systems";
  }
  if (kind == kReferenceTableKind)
    return fmt::format("reference table of {} runs", check_reference_table(file).runs.size());
  if (std::ranges::find(function_kinds(), kind) != function_kinds().end()) {
    check_known_points(load_problem(file));
  } else {
    check_illustration(file);
  }
  return "problem of kind " + kind;
}

}  // namespace

void add_validate_command(CLI::App& app, const Catalogue& catalogue, int& exit_code) {
  auto files = std::make_shared<std::vector<std::string>>();
  CLI::App* command = app.add_subcommand("validate", "Check problem files, suites and configs");
  command->add_option("files", *files, "YAML files")->required();
  command->callback([files, &catalogue, &exit_code] {
    exit_code = kDone;
    for (const std::string& file : *files) {
      try {
        fmt::print("{}: good, {}\n", file, checked_kind(file, catalogue));
      } catch (const std::exception& error) {
        fmt::print(stderr, "{}\n", error.what());
        exit_code = kCheckFailed;
      }
    }
  });
}

}  // namespace gcslab
