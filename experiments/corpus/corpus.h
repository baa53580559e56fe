#pragma once

// Where problems, suites and configs are found, and by what names.

#include <filesystem>
#include <string>
#include <vector>

namespace gcslab {

/// A file of the corpus under its name: its path below the corpus without extension, such as "curves/folium".
struct CorpusEntry {
  std::string name;
  std::filesystem::path path;
};

/// Looks names up in folders, the first that has one first.
class Corpus {
 public:
  /// The corpus that the program uses: $GCSLAB_DATA, the source tree, the installed data; configs likewise.
  static Corpus standard();
  Corpus(std::vector<std::filesystem::path> data_folders, std::vector<std::filesystem::path> config_folders);

  /// All problems, in order of name.
  std::vector<CorpusEntry> problems() const;
  std::vector<CorpusEntry> suites() const;
  std::vector<CorpusEntry> configs() const;

  /// The file of a problem: a path if such a file exists, else a corpus name. Throws InputError with the
  /// nearest name.
  std::filesystem::path problem_path(const std::string& name_or_path) const;
  /// The problems that a config's entry stands for: itself, or the members of "suite:NAME".
  std::vector<std::string> expand(const std::string& entry) const;
  /// The problems that a suite's file lists; each is there.
  std::vector<std::string> suite_members(const std::filesystem::path& path) const;

 private:
  std::vector<std::filesystem::path> data_folders_;
  std::vector<std::filesystem::path> config_folders_;
};

}  // namespace gcslab
