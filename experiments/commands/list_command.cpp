#include "experiments/commands/list_command.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <fmt/format.h>
#include <memory>

#include "base/nearest_name.h"
#include "base/yaml_reader.h"
#include "experiments/commands/exit_code.h"
#include "experiments/corpus/corpus.h"
#include "experiments/tasks/job_result.h"
#include "experiments/tasks/registry.h"

namespace gcslab {
namespace {

/// One line of a list: a name, what kind it is of, and a title.
struct ListedItem {
  std::string name;
  std::string kind;
  std::string title;
};

std::string text_at(const YamlNode& file, std::string_view key) {
  const auto value = file.find(key);
  return value && value->is_scalar() ? value->text() : "";
}

std::vector<ListedItem> from_files(const std::vector<CorpusEntry>& entries, std::string_view kind_key) {
  std::vector<ListedItem> items;
  for (const CorpusEntry& entry : entries) {
    const YamlNode file = YamlNode::load_file(entry.path);
    items.push_back({entry.name, text_at(file, kind_key), text_at(file, "title")});
  }
  return items;
}

std::vector<ListedItem> all_methods() {
  std::vector<ListedItem> items;
  for (const TaskEntry& entry : task_registry().entries()) {
    for (const MethodInfo& method : entry.task->methods())
      items.push_back({method.name, entry.name, method.summary});
  }
  return items;
}

std::vector<ListedItem> items_of(const std::string& what) {
  const Corpus corpus = Corpus::standard();
  if (what == "problems") return from_files(corpus.problems(), "kind");
  if (what == "suites") return from_files(corpus.suites(), "");
  if (what == "configs") return from_files(corpus.configs(), "task");
  return all_methods();
}

void print(const std::vector<ListedItem>& items) {
  std::size_t name_width = 0, kind_width = 0;
  for (const ListedItem& item : items) {
    name_width = std::max(name_width, item.name.size());
    kind_width = std::max(kind_width, item.kind.size());
  }
  for (const ListedItem& item : items) {
    fmt::print("{:<{}}  {:<{}}  {}\n", item.name, name_width, item.kind, kind_width, item.title);
  }
}

void print_json(const std::vector<ListedItem>& items) {
  Json list = Json::array();
  for (const ListedItem& item : items) {
    list.push_back({{"name", item.name}, {"kind", item.kind}, {"title", item.title}});
  }
  fmt::print("{}\n", list.dump(2));
}

struct Settings {
  std::string what;
  std::string kind;
  bool json = false;
};

}  // namespace

void add_list_command(CLI::App& app, int& exit_code) {
  auto settings = std::make_shared<Settings>();
  CLI::App* command = app.add_subcommand("list", "List what an experiment can name");
  command->add_option("what", settings->what, "problems, methods, suites or configs")
      ->required()
      ->check(CLI::IsMember({"problems", "methods", "suites", "configs"}));
  command->add_option("--kind", settings->kind,
                      "only this kind (of problems) or task (of methods and configs)");
  command->add_flag("--json", settings->json, "machine-readable");
  command->callback([settings, &exit_code] {
    std::vector<ListedItem> items = items_of(settings->what);
    if (!settings->kind.empty() && settings->what == "suites")
      throw InputError("--kind: suites have no kinds");
    if (!settings->kind.empty()) {
      std::vector<std::string> kinds;
      for (const ListedItem& item : items) {
        if (std::ranges::find(kinds, item.kind) == kinds.end()) kinds.push_back(item.kind);
      }
      if (std::ranges::find(kinds, settings->kind) == kinds.end()) {
        throw InputError("--kind: " + unknown_name_message("kind", settings->kind, kinds));
      }
      std::erase_if(items, [&](const ListedItem& item) { return item.kind != settings->kind; });
    }
    settings->json ? print_json(items) : print(items);
    exit_code = kDone;
  });
}

}  // namespace gcslab
