#include "experiments/runner/report_item.h"

#include <algorithm>

#include "base/yaml_reader.h"
#include "experiments/runner/config_reader.h"
#include "experiments/runner/experiment_config.h"
#include "experiments/tasks/catalogue.h"

namespace gcslab {
namespace {

const std::vector<std::string> kTableKeys = {"file",   "caption", "kind",   "rows",      "columns",
                                             "values", "best",    "filter", "references"};
const std::vector<std::string> kFigureKeys = {"file",    "caption", "kind",   "rows",
                                              "columns", "values",  "filter", "references"};

/// What names in a report item may refer to.
struct Vocabulary {
  const ExperimentConfig& config;
  std::vector<std::string> axes;
  std::vector<std::string> values;
};

Vocabulary vocabulary_of(const ExperimentConfig& config, const Task& task) {
  Vocabulary vocabulary{config, config.axes(), config.axes()};
  for (const ValueInfo& value : task.values()) vocabulary.values.push_back(value.name);
  for (const std::string& measure : report_measures()) vocabulary.values.push_back(measure);
  return vocabulary;
}

void refuse_repetition(const YamlNode& word, const std::vector<std::string>& earlier) {
  if (std::ranges::find(earlier, word.text()) != earlier.end())
    word.fail("is '" + word.text() + "' a second time");
}

std::vector<std::string> known_words(const YamlNode& node, const char* what,
                                     const std::vector<std::string>& known) {
  std::vector<std::string> words;
  for (const YamlNode& word : one_or_more(node)) {
    refuse_repetition(word, words);
    words.push_back(known_word(word, what, known));
  }
  return words;
}

/// A value or a quotient of two.
std::string read_value(const YamlNode& node, const std::vector<std::string>& known) {
  std::string text = node.text();
  const std::size_t slash = text.find('/');
  if (slash == std::string::npos) return known_word(node, "value", known);
  for (const std::string& part : {text.substr(0, slash), text.substr(slash + 1)}) {
    if (std::ranges::find(known, part) != known.end()) continue;
    throw InputError(node.where(), unknown_name_message("value", part, known));
  }
  return text;
}

std::vector<std::string> read_values(const YamlNode& node, const std::vector<std::string>& known) {
  std::vector<std::string> values;
  for (const YamlNode& value : one_or_more(node)) {
    refuse_repetition(value, values);
    values.push_back(read_value(value, known));
  }
  return values;
}

std::map<std::string, std::vector<std::string>> read_filter(const YamlNode& node,
                                                            const Vocabulary& vocabulary) {
  node.allow_keys(vocabulary.axes);
  std::map<std::string, std::vector<std::string>> filter;
  for (const auto& [axis, shown] : node.entries()) {
    filter[axis] = known_words(shown, axis.c_str(), vocabulary.config.axis_values(axis));
  }
  return filter;
}

void refuse_shared_axes(const ReportItem& item) {
  for (const std::string& axis : item.columns) {
    if (std::ranges::find(item.rows, axis) != item.rows.end()) {
      throw InputError(item.where, "axis '" + axis + "' is both in rows and in columns");
    }
  }
}

std::vector<PlacedText> read_references(const YamlNode& node) {
  std::vector<PlacedText> references;
  std::vector<std::string> names;
  for (const YamlNode& name : one_or_more(node)) {
    refuse_repetition(name, names);
    names.push_back(name.text());
    references.push_back({name.text(), name.where()});
  }
  return references;
}

/// The keys that tables and figures share.
ReportItem read_common(const YamlNode& node, const Vocabulary& vocabulary) {
  ReportItem item;
  item.where = node.where();
  item.file = file_name_word(node.at("file"));
  if (const auto caption = node.find("caption")) item.caption = caption->text();
  if (const auto rows = node.find("rows")) item.rows = known_words(*rows, "axis", vocabulary.axes);
  if (const auto columns = node.find("columns"))
    item.columns = known_words(*columns, "axis", vocabulary.axes);
  if (const auto values = node.find("values")) item.values = read_values(*values, vocabulary.values);
  if (const auto filter = node.find("filter")) item.filter = read_filter(*filter, vocabulary);
  if (const auto references = node.find("references")) item.references = read_references(*references);
  refuse_shared_axes(item);
  return item;
}

void read_options(const YamlNode& node, const std::vector<std::string>& own_keys, ReportItem& item) {
  for (const auto& [key, value] : node.entries()) {
    if (std::ranges::find(own_keys, key) != own_keys.end()) continue;
    item.options.emplace(key, PlacedText{value.text(), value.where()});
  }
}

ReportItem read_table(const YamlNode& node, const Vocabulary& vocabulary) {
  ReportItem item = read_common(node, vocabulary);
  item.form = ReportItem::Form::table;
  if (const auto kind = node.find("kind")) {
    item.kind = kind->text();
  } else {
    for (const char* required : {"rows", "values"}) static_cast<void>(node.at(required));
  }
  if (const auto best = node.find("best")) item.best = known_word(*best, "choice of best", {"min", "max"});
  read_options(node, kTableKeys, item);
  return item;
}

ReportItem read_figure(const YamlNode& node, const Vocabulary& vocabulary) {
  ReportItem item = read_common(node, vocabulary);
  item.form = ReportItem::Form::figure;
  item.kind = node.at("kind").text();
  read_options(node, kFigureKeys, item);
  return item;
}

/// An option that nobody knows may be a misspelt key of every table or figure.
void check_item(const ReportItem& item, const Catalogue& catalogue) {
  if (!catalogue.check_report_item) return;
  try {
    catalogue.check_report_item(item);
  } catch (const InputError&) {
    const auto& own_keys = item.form == ReportItem::Form::table ? kTableKeys : kFigureKeys;
    for (const auto& [key, value] : item.options) {
      if (nearest_name(key, own_keys))
        throw InputError(value.where, unknown_name_message("key", key, own_keys));
    }
    throw;
  }
}

ReportItem read_item(const YamlNode& node, const Vocabulary& vocabulary) {
  node.allow_keys({"table", "figure"});
  const auto table = node.find("table");
  const auto figure = node.find("figure");
  if (static_cast<bool>(table) == static_cast<bool>(figure)) node.fail("must be either a table or a figure");
  return table ? read_table(*table, vocabulary) : read_figure(*figure, vocabulary);
}

}  // namespace

const std::vector<std::string>& report_measures() {
  static const std::vector<std::string> measures = {"wall_s", "cpu_s", "prepare_s", "peak_rss_mb", "status"};
  return measures;
}

std::vector<ReportItem> read_report(const YamlNode& report, const ExperimentConfig& config,
                                    const Catalogue& catalogue) {
  const Vocabulary vocabulary = vocabulary_of(config, *catalogue.tasks.at(config.task).task);
  std::vector<ReportItem> items;
  for (const YamlNode& node : report.items()) {
    ReportItem item = read_item(node, vocabulary);
    if (std::ranges::find(items, item.file, &ReportItem::file) != items.end()) {
      throw InputError(item.where, "two report items write the file '" + item.file + "'");
    }
    check_item(item, catalogue);
    items.push_back(std::move(item));
  }
  return items;
}

}  // namespace gcslab
