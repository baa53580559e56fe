// The includes of the source tree follow the table of CONTRIBUTING.md.

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace gcslab {
namespace {

namespace fs = std::filesystem;

/// What each folder may include directly; what those include comes with them.
using Table = std::map<std::string, std::vector<std::string>>;

const Table& allowed() {
  static const Table table = {
      {"base", {}},
      {"interval", {"base"}},
      {"expression", {"interval"}},
      {"geometry", {"expression"}},
      {"polynomial", {"expression"}},
      {"univariate", {"polynomial"}},
      {"linear_program", {"interval"}},
      {"verifier", {"expression"}},
      {"enclosure", {"polynomial"}},
      {"covering", {"enclosure"}},
      {"certification", {"enclosure"}},
      {"box_solver", {"certification", "linear_program", "univariate"}},
      {"homotopy", {"geometry", "certification"}},
      {"construction", {"homotopy"}},
      {"local_search", {"certification"}},
      {"packing", {"box_solver"}},
      {"spline", {"polynomial", "univariate", "box_solver"}},
      {"experiments/corpus", {"covering", "geometry", "packing"}},
      {"experiments/process", {}},
      {"experiments/peers", {"experiments/process", "box_solver"}},
      {"experiments/solving",
       {"experiments/corpus", "experiments/peers", "box_solver", "homotopy", "construction", "local_search"}},
      {"experiments/tasks", {"experiments/solving"}},
      {"experiments/runner", {"experiments/tasks", "experiments/provenance.h"}},
      {"experiments/reporting", {"experiments/runner"}},
      {"experiments/commands", {"experiments/reporting", "verifier"}},
      {"experiments/microbenchmarks", {"experiments/tasks", "linear_program", "spline"}},
      {"experiments/provenance.h", {}},
  };
  return table;
}

/// The room that an included file stands in.
std::string room_of(const std::string& include) {
  const std::size_t first = include.find('/');
  const std::string top = include.substr(0, first);
  return top == "experiments" ? include.substr(0, include.find('/', first + 1)) : top;
}

void add_reachable(const std::string& folder, std::set<std::string>& reachable) {
  if (!reachable.insert(folder).second) return;
  for (const std::string& next : allowed().at(folder)) add_reachable(next, reachable);
}

std::vector<std::string> quoted_includes(const fs::path& file) {
  static const std::regex pattern("^#include \"([^\"]+)\"");
  std::vector<std::string> result;
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);) {
    std::smatch match;
    if (std::regex_search(line, match, pattern)) result.push_back(match[1]);
  }
  return result;
}

std::vector<fs::path> sources_below(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const auto extension = entry.path().extension();
    if (extension == ".h" || extension == ".cpp") files.push_back(entry.path());
  }
  return files;
}

void expect_allowed_includes(const std::string& parent, const std::string& prefix) {
  for (const auto& folder : fs::directory_iterator(fs::path(GCSLAB_SOURCE_DIR) / parent)) {
    if (!folder.is_directory()) continue;
    const std::string name = prefix + folder.path().filename().string();
    ASSERT_TRUE(allowed().contains(name)) << name << " has no line in the table of this test";
    std::set<std::string> reachable;
    add_reachable(name, reachable);
    for (const fs::path& file : sources_below(folder)) {
      for (const std::string& include : quoted_includes(file)) {
        EXPECT_TRUE(reachable.contains(room_of(include))) << file << " includes " << include;
      }
    }
  }
}

TEST(Architecture, FoldersIncludeOnlyWhatTheTableAllows) {
  expect_allowed_includes("lib", "");
  expect_allowed_includes("experiments", "experiments/");
}

TEST(Architecture, OnlyExperimentsReadClocksAndTheEnvironment) {
  static const std::regex pattern("getenv|<chrono>|clock_gettime|system_clock|steady_clock");
  for (const fs::path& file : sources_below(fs::path(GCSLAB_SOURCE_DIR) / "lib")) {
    std::ifstream stream(file);
    for (std::string line; std::getline(stream, line);) {
      EXPECT_FALSE(std::regex_search(line, pattern)) << file << ": " << line;
    }
  }
}

TEST(Architecture, FilesStayShort) {
  for (const char* folder : {"lib", "experiments", "tests"}) {
    for (const fs::path& file : sources_below(fs::path(GCSLAB_SOURCE_DIR) / folder)) {
      std::ifstream stream(file);
      int lines = 0;
      for (std::string line; std::getline(stream, line);) ++lines;
      EXPECT_LE(lines, 450) << file << " holds two ideas";
    }
  }
}

}  // namespace
}  // namespace gcslab
