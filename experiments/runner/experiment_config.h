#pragma once

// The description of an experiment: which question is asked of which problems by which methods.
//
// The loader is strict: a config that loads can run. Unknown and duplicate keys, misspelt names of problems,
// methods, options and parameters, and values out of range are refused in one line with file, line and the
// nearest known name. The same shape is described for editors in configs/schema/experiment.schema.json.

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/option.h"
#include "experiments/runner/report_item.h"
#include "experiments/tasks/task.h"

namespace gcslab {

struct Catalogue;

struct ProblemChoice {
  std::string name;
  std::string content_hash;
  SourceLocation where;
};

/// A method with options.
struct MethodChoice {
  std::string name;
  /// Unique in the experiment: as given, or the name, followed by "(option=value)" where several choices of
  /// one method differ in that option.
  std::string label;
  int version = 1;
  Promise promise = Promise::rigorous;
  Options options;  ///< defaults filled in
  SourceLocation where;
};

/// The values that a parameter takes, in the order of the config; texts of to_string(OptionValue).
struct ParameterAxis {
  std::string name;
  std::vector<std::string> values;
};

struct ExperimentConfig {
  std::filesystem::path file;
  std::string experiment;  ///< a name that can be a folder
  std::string title;
  std::string source;
  std::string task;
  std::vector<ProblemChoice> problems;  ///< suites expanded
  std::vector<MethodChoice> methods;
  std::vector<ParameterAxis> parameters;        ///< those that the config names
  std::vector<OptionSpec> declared_parameters;  ///< all that the task has
  std::vector<std::uint64_t> seeds = {1};
  int repetitions = 1;
  Limits limits;
  std::vector<ReportItem> report;

  /// The axes that tables and figures can use, and the texts of the values along one of them.
  std::vector<std::string> axes() const;
  std::vector<std::string> axis_values(const std::string& axis) const;
};

/// Reads and checks a config. Every job of it can then be asked. Throws InputError.
ExperimentConfig load_experiment(const std::filesystem::path& file, const Catalogue& catalogue);

/// Reads several configs before anything is done with the first: a fault in the last one costs no time. No
/// two are of one experiment.
std::vector<ExperimentConfig> load_experiments(const std::vector<std::string>& files,
                                               const Catalogue& catalogue);

/// The same for a text; `file` names it in errors.
ExperimentConfig parse_experiment(const std::string& text, const std::filesystem::path& file,
                                  const Catalogue& catalogue);

}  // namespace gcslab
