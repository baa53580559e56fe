#include "experiments/runner/experiment_config.h"

#include <algorithm>
#include <charconv>
#include <fmt/format.h>
#include <set>

#include "base/atomic_file.h"
#include "base/yaml_reader.h"
#include "experiments/runner/config_reader.h"
#include "experiments/runner/job_plan.h"
#include "experiments/tasks/catalogue.h"

namespace gcslab {
namespace {

// ---- problems
// ------------------------------------------------------------------------------------------------------

std::vector<ProblemChoice> read_problems(const YamlNode& node, const ProblemSource& source) {
  std::vector<ProblemChoice> problems;
  std::set<std::string> written;
  std::set<std::string> known;
  for (const YamlNode& entry : one_or_more(node)) {
    if (!written.insert(entry.text()).second)
      entry.fail("is '" + entry.text() + "', which is listed already");
    for (const std::string& name : at_place(entry, [&] { return source.expand(entry.text()); })) {
      if (!known.insert(name).second) continue;  // suites may overlap
      const std::string hash = at_place(entry, [&] { return source.content_hash(name); });
      problems.push_back({name, hash, entry.where()});
    }
  }
  if (problems.empty()) node.fail("names no problem");
  return problems;
}

// ---- methods and their labels
// ----------------------------------------------------------------------------------------

Options read_options(const YamlNode& node, const MethodInfo& method) {
  std::map<std::string, std::string> given;
  for (const auto& [name, value] : node.entries()) {
    given[name] = value.text();
    at_place(value, [&, &key = name] { return Options(method.options, {{key, given[key]}}, method.name); });
  }
  return Options(method.options, given, method.name);
}

MethodChoice read_method(const YamlNode& node, const Task& task) {
  node.allow_keys({"name", "label", "options"});
  const YamlNode name = node.at("name");
  const MethodInfo method = at_place(name, [&] { return task.method(name.text()); });
  MethodChoice choice;
  choice.name = method.name;
  choice.version = method.version;
  choice.promise = method.promise;
  choice.where = node.where();
  const auto options = node.find("options");
  choice.options = options ? read_options(*options, method) : Options(method.options, {}, method.name);
  if (method.promise_with) choice.promise = method.promise_with(choice.options);
  if (const auto label = node.find("label")) choice.label = label->text();
  return choice;
}

/// The options in which `choice` differs from another choice of its method, as "name=value, ...".
std::string differing_options(const MethodChoice& choice, const std::vector<MethodChoice>& all) {
  std::string text;
  for (const auto& [name, value] : choice.options.values()) {
    const bool differs = std::ranges::any_of(all, [&, &key = name, &mine = value](const MethodChoice& other) {
      return other.name == choice.name && other.options.values().at(key) != mine;
    });
    if (differs) text += (text.empty() ? "" : ", ") + name + "=" + to_string(value);
  }
  return text;
}

void fill_in_labels(std::vector<MethodChoice>& methods) {
  const std::vector<MethodChoice> as_given = methods;
  for (MethodChoice& choice : methods) {
    if (!choice.label.empty()) continue;
    const std::string difference = differing_options(choice, as_given);
    choice.label = difference.empty() ? choice.name : choice.name + " (" + difference + ")";
  }
}

void refuse_equal_methods(const std::vector<MethodChoice>& methods) {
  for (auto choice = methods.begin(); choice != methods.end(); ++choice) {
    for (auto other = methods.begin(); other != choice; ++other) {
      if (other->name == choice->name && other->options.values() == choice->options.values()) {
        throw InputError(choice->where, "method '" + choice->name + "' with these options is listed already");
      }
      if (other->label == choice->label) {
        throw InputError(choice->where,
                         "two methods have the label '" + choice->label + "'; give one another `label`");
      }
    }
  }
}

std::vector<MethodChoice> read_methods(const YamlNode& node, const Task& task) {
  std::vector<MethodChoice> methods;
  for (const YamlNode& entry : node.is_map() ? std::vector{node} : one_or_more(node)) {
    methods.push_back(read_method(entry, task));
  }
  fill_in_labels(methods);
  refuse_equal_methods(methods);
  return methods;
}

// ---- parameters, seeds, limits
// ---------------------------------------------------------------------------------------

ParameterAxis read_parameter(const std::string& name, const YamlNode& node, const Task& task) {
  const std::vector<OptionSpec> declared = task.parameters();
  ParameterAxis axis{name, {}};
  for (const YamlNode& value : one_or_more(node)) {
    const Options parsed = at_place(value, [&] {
      return Options(declared, {{name, value.text()}}, "task " + task.name());
    });
    const std::string text = to_string(parsed.values().at(name));
    if (std::ranges::find(axis.values, text) != axis.values.end())
      value.fail("is " + text + ", which is listed already");
    axis.values.push_back(text);
  }
  return axis;
}

std::vector<ParameterAxis> read_parameters(const YamlNode& node, const Task& task) {
  std::vector<std::string> known;
  for (const OptionSpec& spec : task.parameters()) known.push_back(spec.name);
  std::vector<ParameterAxis> axes;
  for (const auto& [name, values] : node.entries()) {
    if (std::ranges::find(known, name) == known.end()) {
      throw InputError(values.where(), unknown_name_message("parameter of task " + task.name(), name, known));
    }
    axes.push_back(read_parameter(name, values, task));
  }
  return axes;
}

/// The seeds of an entry: a number, or "0..99" for all from the first to the last.
std::vector<std::uint64_t> seeds_of(const YamlNode& entry) {
  constexpr std::uint64_t kMost = 100'000;
  const std::string text = entry.text();
  const std::size_t dots = text.find("..");
  if (dots == std::string::npos) {
    if (entry.integer() < 0) entry.fail("is negative; a seed is 0 or more");
    return {static_cast<std::uint64_t>(entry.integer())};
  }
  std::uint64_t first = 0, last = 0;
  const char* const middle = text.data() + dots;
  const char* const end = text.data() + text.size();
  const bool is_read = std::from_chars(text.data(), middle, first).ptr == middle &&
                       std::from_chars(middle + 2, end, last).ptr == end && dots > 0 && middle + 2 != end;
  if (!is_read || last < first || last - first >= kMost)
    entry.fail("is '" + text + "'; expected a seed, or a range such as 0..99");
  std::vector<std::uint64_t> seeds;
  for (std::uint64_t seed = first; seed <= last; ++seed) seeds.push_back(seed);
  return seeds;
}

std::vector<std::uint64_t> read_seeds(const YamlNode& node) {
  std::vector<std::uint64_t> seeds;
  for (const YamlNode& entry : one_or_more(node)) {
    for (const std::uint64_t seed : seeds_of(entry)) {
      if (std::ranges::find(seeds, seed) != seeds.end()) entry.fail("is listed already");
      seeds.push_back(seed);
    }
  }
  return seeds;
}

int read_repetitions(const YamlNode& node) {
  constexpr int kMost = 1'000'000;
  const std::int64_t count = node.integer();
  if (count < 1 || count > kMost) node.fail(fmt::format("is {}; expected 1 to {}", count, kMost));
  return static_cast<int>(count);
}

double read_limit(const YamlNode& node) {
  constexpr double kMost = 1e9;
  const double limit = node.real();
  if (!(limit > 0 && limit <= kMost))
    node.fail(fmt::format("is {}; expected more than 0, at most {}", limit, kMost));
  return limit;
}

Limits read_limits(const YamlNode& node) {
  node.allow_keys({"wall_s", "cpu_s", "memory_mb"});
  Limits limits;
  if (const auto wall = node.find("wall_s")) limits.wall_s = read_limit(*wall);
  if (const auto cpu = node.find("cpu_s")) limits.cpu_s = read_limit(*cpu);
  if (const auto memory = node.find("memory_mb")) limits.memory_mb = read_limit(*memory);
  return limits;
}

// ---- the whole
// -------------------------------------------------------------------------------------------------------

/// The task sees every job before the first one starts.
void check_jobs(const ExperimentConfig& config, const Task& task) {
  for (const Job& job : plan_jobs(config)) {
    try {
      task.check(job);
    } catch (const InputError& error) {
      const auto problem = std::ranges::find(config.problems, job.problem, &ProblemChoice::name);
      throw InputError(problem->where, fmt::format("{}: {}", job.problem, error.what()));
    }
  }
}

ExperimentConfig read_config(const YamlNode& root, const std::filesystem::path& file,
                             const Catalogue& catalogue) {
  root.allow_keys({"experiment", "title", "source", "task", "problems", "methods", "parameters", "seeds",
                   "repetitions", "limits", "report"});
  ExperimentConfig config;
  config.file = file;
  config.experiment = file_name_word(root.at("experiment"));
  const auto title = root.find("title");
  config.title = title ? title->text() : config.experiment;
  if (const auto source = root.find("source")) config.source = source->text();
  config.task = known_word(root.at("task"), "task", catalogue.tasks.names());
  const Task& task = *catalogue.tasks.at(config.task).task;
  config.declared_parameters = task.parameters();
  config.problems = read_problems(root.at("problems"), catalogue.problems);
  config.methods = read_methods(root.at("methods"), task);
  if (const auto parameters = root.find("parameters")) config.parameters = read_parameters(*parameters, task);
  if (const auto seeds = root.find("seeds")) config.seeds = read_seeds(*seeds);
  if (const auto repetitions = root.find("repetitions")) config.repetitions = read_repetitions(*repetitions);
  if (const auto limits = root.find("limits")) config.limits = read_limits(*limits);
  if (const auto report = root.find("report")) config.report = read_report(*report, config, catalogue);
  check_jobs(config, task);
  return config;
}

}  // namespace

std::string file_name_word(const YamlNode& node) {
  std::string word = node.text();
  const bool plain = std::ranges::all_of(word, [](unsigned char c) {
    return c < 128 && (std::isalnum(c) != 0 || c == '.' || c == '_' || c == '-');
  });
  if (word.empty() || word.front() == '.' || !plain) {
    node.fail("is '" + word + "'; it names files: letters, digits, '.', '_' and '-' are allowed");
  }
  return word;
}

std::vector<std::string> ExperimentConfig::axes() const {
  std::vector<std::string> names = {"problem", "method", "seed"};
  for (const OptionSpec& spec : declared_parameters) names.push_back(spec.name);
  return names;
}

std::vector<std::string> ExperimentConfig::axis_values(const std::string& axis) const {
  std::vector<std::string> texts;
  if (axis == "problem") {
    for (const ProblemChoice& problem : problems) texts.push_back(problem.name);
  } else if (axis == "method") {
    for (const MethodChoice& method : methods) texts.push_back(method.label);
  } else if (axis == "seed") {
    for (const std::uint64_t seed : seeds) texts.push_back(std::to_string(seed));
  } else if (const auto given = std::ranges::find(parameters, axis, &ParameterAxis::name);
             given != parameters.end()) {
    texts = given->values;
  } else if (const auto spec = std::ranges::find(declared_parameters, axis, &OptionSpec::name);
             spec != declared_parameters.end()) {
    texts.push_back(to_string(spec->default_value));
  }
  return texts;
}

ExperimentConfig parse_experiment(const std::string& text, const std::filesystem::path& file,
                                  const Catalogue& catalogue) {
  return read_config(YamlNode::parse(text, file.string()), file, catalogue);
}

ExperimentConfig load_experiment(const std::filesystem::path& file, const Catalogue& catalogue) {
  return parse_experiment(read_file(file), file, catalogue);
}

std::vector<ExperimentConfig> load_experiments(const std::vector<std::string>& files,
                                               const Catalogue& catalogue) {
  std::vector<ExperimentConfig> configs;
  std::set<std::string> names;
  for (const std::string& file : files) {
    configs.push_back(load_experiment(file, catalogue));
    const std::string& name = configs.back().experiment;
    if (!names.insert(name).second) {
      throw InputError(file + ": experiment '" + name + "' is the name of two configs");
    }
  }
  return configs;
}

}  // namespace gcslab
