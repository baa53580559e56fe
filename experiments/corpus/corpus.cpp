#include "experiments/corpus/corpus.h"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <optional>

#include "base/error.h"
#include "base/nearest_name.h"
#include "base/yaml_reader.h"

namespace gcslab {
namespace {

namespace fs = std::filesystem;

/// All YAML files below the folders; of two with one name the one in the earlier folder counts.
std::vector<CorpusEntry> yaml_files(const std::vector<fs::path>& folders) {
  std::map<std::string, fs::path> found;
  for (const fs::path& folder : folders) {
    if (!fs::is_directory(folder)) continue;
    for (const auto& file : fs::recursive_directory_iterator(folder)) {
      if (file.path().extension() != ".yaml") continue;
      const fs::path name = file.path().lexically_relative(folder).replace_extension();
      found.try_emplace(name.generic_string(), file.path());
    }
  }
  std::vector<CorpusEntry> entries;
  for (auto& [name, path] : found) entries.push_back({name, path});
  return entries;
}

/// The file of that name in the first of the folders that has it, as yaml_files would list it.
std::optional<fs::path> yaml_file(const std::vector<fs::path>& folders, const fs::path& name) {
  const bool is_below = name.is_relative() && name.lexically_normal() == name && name.begin() != name.end() &&
                        *name.begin() != "..";
  for (const fs::path& folder : folders) {
    fs::path path = folder / name;
    path += ".yaml";
    if (is_below && fs::is_regular_file(path)) return path;
  }
  return std::nullopt;
}

std::vector<std::string> names_of(const std::vector<CorpusEntry>& entries) {
  std::vector<std::string> names;
  for (const CorpusEntry& entry : entries) names.push_back(entry.name);
  return names;
}

std::vector<fs::path> below(const std::vector<fs::path>& folders, const char* name) {
  std::vector<fs::path> result;
  for (const fs::path& folder : folders) result.push_back(folder / name);
  return result;
}

std::vector<fs::path> existing(std::vector<fs::path> folders) {
  std::erase_if(folders, [](const fs::path& folder) { return folder.empty() || !fs::is_directory(folder); });
  return folders;
}

}  // namespace

Corpus Corpus::standard() {
  const char* environment = std::getenv("GCSLAB_DATA");
  return Corpus(existing({environment != nullptr ? environment : "", GCSLAB_SOURCE_DIR "/data",
                          GCSLAB_INSTALL_DATA_DIR}),
                existing({GCSLAB_SOURCE_DIR "/configs", GCSLAB_INSTALL_CONFIG_DIR}));
}

Corpus::Corpus(std::vector<fs::path> data_folders, std::vector<fs::path> config_folders)
    : data_folders_(std::move(data_folders)), config_folders_(std::move(config_folders)) {}

std::vector<CorpusEntry> Corpus::problems() const { return yaml_files(data_folders_); }
std::vector<CorpusEntry> Corpus::suites() const { return yaml_files(below(config_folders_, "suites")); }

std::vector<CorpusEntry> Corpus::configs() const {
  std::vector<CorpusEntry> entries = yaml_files(config_folders_);
  std::erase_if(entries, [](const CorpusEntry& entry) { return entry.name.starts_with("suites/"); });
  return entries;
}

fs::path Corpus::problem_path(const std::string& name_or_path) const {
  if (fs::is_regular_file(name_or_path)) return name_or_path;
  if (fs::is_directory(name_or_path))
    throw InputError(name_or_path + ": is a folder; a problem file was expected");
  if (const std::optional<fs::path> path = yaml_file(data_folders_, name_or_path)) return *path;
  throw InputError(unknown_name_message("problem", name_or_path, names_of(problems())) +
                   "; no such file exists, and `gcslab list problems` does not have it");
}

std::vector<std::string> Corpus::suite_members(const fs::path& path) const {
  const YamlNode file = YamlNode::load_file(path);
  file.allow_keys({"suite", "title", "problems", "notes"});
  std::vector<std::string> members;
  for (const YamlNode& member : file.at("problems").items()) {
    try {
      static_cast<void>(problem_path(member.text()));
    } catch (const InputError& error) {
      member.fail(error.what());
    }
    members.push_back(member.text());
  }
  return members;
}

std::vector<std::string> Corpus::expand(const std::string& entry) const {
  constexpr std::string_view kSuite = "suite:";
  if (!entry.starts_with(kSuite)) {
    static_cast<void>(problem_path(entry));
    return {entry};
  }
  const std::string wanted = entry.substr(kSuite.size());
  for (const CorpusEntry& suite : suites()) {
    if (suite.name == wanted) return suite_members(suite.path);
  }
  throw InputError(unknown_name_message("suite", wanted, names_of(suites())));
}

}  // namespace gcslab
