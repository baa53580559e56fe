#include "experiments/corpus/reference_table.h"

#include <algorithm>
#include <cmath>

#include "base/nearest_name.h"
#include "base/yaml_reader.h"
#include "experiments/corpus/corpus.h"

namespace gcslab {
namespace {

const std::vector<std::string> kTimings = {"cpu_s", "wall_s"};
const std::vector<std::string> kCounts = {"boxes",   "bisections",   "solutions", "undecided", "lost_roots",
                                          "classes", "flat_classes", "crossings", "steps"};

std::string required_text(const YamlNode& node, std::string_view key) {
  const YamlNode value = node.at(key);
  if (value.text().empty()) value.fail("is empty");
  return value.text();
}

std::string optional_text(const YamlNode& node, std::string_view key) {
  const auto value = node.find(key);
  return value ? value->text() : "";
}

double read_seconds(const YamlNode& node) {
  const double seconds = node.real();
  if (!std::isfinite(seconds) || seconds < 0) node.fail("must be a time: a finite number of seconds");
  return seconds;
}

std::int64_t read_count(const YamlNode& node) {
  const std::int64_t count = node.integer();
  if (count < 0) node.fail("must be a count: 0 or more");
  return count;
}

Status read_status(const YamlNode& node) {
  try {
    return status_from_name(node.text());
  } catch (const InputError& error) {
    node.fail(error.what());
  }
}

std::vector<std::string> run_keys() {
  std::vector<std::string> keys = {"status", "said"};
  keys.insert(keys.end(), kTimings.begin(), kTimings.end());
  keys.insert(keys.end(), kCounts.begin(), kCounts.end());
  return keys;
}

std::string joined(const std::string& first, const std::string& second) {
  return first.empty() || second.empty() ? first + second : first + "; " + second;
}

ReferenceRun read_run(const YamlNode& node, const std::string& note) {
  node.allow_keys(run_keys());
  ReferenceRun run;
  run.status = read_status(node.at("status"));
  run.reason = joined(optional_text(node, "said"), note);
  for (const std::string& key : kTimings) {
    if (const auto value = node.find(key)) run.timings[key] = read_seconds(*value);
  }
  for (const std::string& key : kCounts) {
    if (const auto value = node.find(key)) run.counts[key] = read_count(*value);
  }
  if (run.status == Status::complete && run.timings.empty()) node.fail("is complete, but has no time");
  return run;
}

/// The key of each method in the file, with its label.
using MethodLabels = std::vector<std::pair<std::string, std::string>>;

MethodLabels read_methods(const YamlNode& node) {
  MethodLabels labels;
  for (const auto& [key, label] : node.entries()) {
    const std::string text = label.text();
    if (text.empty()) label.fail("is empty");
    if (std::ranges::find(labels, text, &MethodLabels::value_type::second) != labels.end())
      label.fail("is '" + text + "' a second time");
    labels.emplace_back(key, text);
  }
  if (labels.empty()) node.fail("names no method");
  return labels;
}

void read_row(const YamlNode& node, const MethodLabels& labels, ReferenceTable& table) {
  node.allow_keys({"problem", "called", "runs", "note"});
  const std::string problem = required_text(node, "problem");
  if (std::ranges::find(table.runs, problem, &ReferenceRun::problem) != table.runs.end())
    node.at("problem").fail("has '" + problem + "' a second time");
  const YamlNode runs = node.at("runs");
  std::vector<std::string> keys;
  for (const auto& [key, label] : labels) keys.push_back(key);
  runs.allow_keys(keys);
  if (runs.entries().empty()) runs.fail("has no run");
  for (const auto& [key, label] : labels) {
    const auto given = runs.find(key);
    if (!given) continue;
    ReferenceRun run = read_run(*given, optional_text(node, "note"));
    run.problem = problem;
    run.method = label;
    table.runs.push_back(std::move(run));
  }
}

/// Drops all methods but that of the key.
void keep_method(const std::string& key, ReferenceTable& table) {
  const auto found = std::ranges::find(table.keys, key);
  if (found == table.keys.end())
    throw InputError(unknown_name_message("method of " + table.name, key, table.keys));
  const std::string label = table.methods[static_cast<std::size_t>(found - table.keys.begin())];
  std::erase_if(table.runs, [&](const ReferenceRun& run) { return run.method != label; });
  table.keys = {key};
  table.methods = {label};
}

std::filesystem::path path_of(const std::string& name) {
  constexpr std::string_view kFolder = "references/";
  if (std::filesystem::is_regular_file(name)) return name;
  std::vector<std::string> known;
  for (const CorpusEntry& entry : Corpus::standard().problems()) {
    if (!entry.name.starts_with(kFolder)) continue;
    known.push_back(entry.name.substr(kFolder.size()));
    if (known.back() == name || entry.name == name) return entry.path;
  }
  throw InputError(unknown_name_message("reference table", name, known));
}

}  // namespace

ReferenceTable load_reference_table(const std::filesystem::path& path) {
  const YamlNode file = YamlNode::load_file(path);
  const YamlNode kind = file.at("kind");
  if (kind.text() != kReferenceTableKind)
    kind.fail("is '" + kind.text() + "'; expected " + kReferenceTableKind);
  file.allow_keys({"kind", "name", "title", "origin", "licence", "notes", "methods", "rows"});
  ReferenceTable table;
  table.name = required_text(file, "name");
  table.title = required_text(file, "title");
  table.origin = required_text(file, "origin");
  table.licence = required_text(file, "licence");
  table.notes = optional_text(file, "notes");
  const MethodLabels labels = read_methods(file.at("methods"));
  for (const auto& [key, label] : labels) {
    table.keys.push_back(key);
    table.methods.push_back(label);
  }
  for (const YamlNode& row : file.at("rows").items()) read_row(row, labels, table);
  if (table.runs.empty()) file.at("rows").fail("has no row");
  return table;
}

ReferenceTable find_reference_table(const std::string& name_or_path) {
  const std::size_t colon = name_or_path.find(':');
  ReferenceTable table = load_reference_table(path_of(name_or_path.substr(0, colon)));
  if (colon != std::string::npos) keep_method(name_or_path.substr(colon + 1), table);
  return table;
}

ReferenceTable check_reference_table(const std::filesystem::path& path) {
  ReferenceTable table = load_reference_table(path);
  const Corpus corpus = Corpus::standard();
  for (const ReferenceRun& run : table.runs) {
    try {
      static_cast<void>(corpus.problem_path(run.problem));
    } catch (const InputError& error) {
      throw InputError({path.string(), 0}, error.what());
    }
  }
  return table;
}

}  // namespace gcslab
