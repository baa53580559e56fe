// Figures of other programs: what the reader takes over, and what it refuses.

#include "experiments/corpus/reference_table.h"

#include <fstream>
#include <gtest/gtest.h>

#include "experiments/corpus/corpus.h"
#include "support/error_text.h"

namespace gcslab {
namespace {

namespace fs = std::filesystem;

class ReferenceTableFile : public testing::Test {
 protected:
  ReferenceTableFile() {
    std::string name = (fs::temp_directory_path() / "gcslab-reference-XXXXXX").string();
    folder_ = ::mkdtemp(name.data());
  }
  ~ReferenceTableFile() override { fs::remove_all(folder_); }

  fs::path file(const std::string& text) const {
    const fs::path path = folder_ / "table.yaml";
    std::ofstream(path) << text;
    return path;
  }

  std::string complaint(const std::string& text) const {
    return error_text([&] { check_reference_table(file(text)); });
  }

 private:
  fs::path folder_;
};

const std::string kHead =
    "kind: reference_table\nname: t\ntitle: T\norigin: o\nlicence: l\nmethods: {a: \"Prover A\", b: B}\n";
const std::string kRow = "  - problem: kinematics/kin1\n    runs: ";

std::string with_run(const std::string& run) { return kHead + "rows:\n" + kRow + "{a: " + run + "}\n"; }

TEST_F(ReferenceTableFile, RunsAreReadAsTheyStand) {
  const ReferenceTable table = load_reference_table(
      file(kHead + "rows:\n" + kRow +
           "{b: {status: partial, said: \"gave up\", cpu_s: 1.5, solutions: 3, lost_roots: 2}, a: {status: "
           "complete, wall_s: 2}}\n    called: K1\n    note: a note\n"));
  EXPECT_EQ(table.methods, (std::vector<std::string>{"Prover A", "B"}));
  ASSERT_EQ(table.runs.size(), 2u);
  EXPECT_EQ(table.runs[0].method, "Prover A") << "in the order of the methods";
  EXPECT_EQ(table.runs[0].timings.at("wall_s"), 2);
  EXPECT_EQ(table.runs[1].status, Status::partial);
  EXPECT_EQ(table.runs[1].reason, "gave up; a note");
  EXPECT_EQ(table.runs[1].timings.at("cpu_s"), 1.5);
  EXPECT_EQ(table.runs[1].counts.at("solutions"), 3);
  EXPECT_EQ(table.runs[1].counts.at("lost_roots"), 2);
  EXPECT_FALSE(table.runs[1].counts.contains("boxes"));
}

TEST_F(ReferenceTableFile, HostileInputIsRefusedWithItsPlace) {
  const std::pair<std::string, std::string> cases[] = {
      {"", "table.yaml"},
      {"kind: system\n", "table.yaml:1: 'kind' is 'system'; expected reference_table"},
      {kHead, "lacks the key 'rows'"},
      {kHead + "rows: []\n", "has no row"},
      {kHead + "rows: 3\n", "is not a list"},
      {kHead + "colour: red\nrows: []\n", "unknown key 'colour'"},
      {with_run("{status: complete, cpu_s: -1}"), "table.yaml:9"},
      {with_run("{status: complete, cpu_s: inf}"), "cpu_s"},
      {with_run("{status: complete, cpu_s: nan}"), "cpu_s"},
      {with_run("{status: complete, cpu_s: 1e999}"), "cpu_s"},
      {with_run("{status: complete, cpu_s: quick}"), "cpu_s"},
      {with_run("{status: complete}"), "is complete, but has no time"},
      {with_run("{status: success, cpu_s: 1}"), "success"},
      {with_run("{cpu_s: 1}"), "lacks the key 'status'"},
      {with_run("{status: complete, cpu_s: 1, boxes: -3}"), "must be a count"},
      {with_run("{status: complete, cpu_s: 1, boxes: 1.5}"), "boxes"},
      {with_run("{status: complete, cpu_s: 1, boxes: 99999999999999999999}"), "boxes"},
      {with_run("{status: complete, cpu_s: 1, solution: 3}"), "did you mean 'solutions'"},
      {kHead + "rows:\n" + kRow + "{c: {status: complete, cpu_s: 1}}\n", "unknown key 'c'"},
      {kHead + "rows:\n" + kRow + "{}\n", "has no run"},
      {with_run("{status: complete, cpu_s: 1}") + kRow + "{a: {status: complete, cpu_s: 1}}\n",
       "has 'kinematics/kin1' a second time"},
      {kHead + "rows:\n  - problem: kinematics/kin11\n    runs: {a: {status: complete, cpu_s: 1}}\n",
       "did you mean 'kinematics/kin1'"},
      {"kind: reference_table\nname: t\ntitle: T\norigin: \"\"\nlicence: l\nmethods: {a: A}\nrows: []\n",
       "table.yaml:4: 'origin' is empty"},
      {"kind: reference_table\nname: t\ntitle: T\norigin: o\nlicence: l\nmethods: {a: A, b: A}\nrows: []\n",
       "is 'A' a second time"},
      {"kind: reference_table\nname: t\ntitle: T\norigin: o\nlicence: l\nmethods: [A]\nrows: []\n",
       "methods"},
      {"kind: reference_table\nrows: [[[[[[[\n", "table.yaml"},
      {std::string("kind: \0reference_table\n", 23), "table.yaml"},
  };
  for (const auto& [text, fragment] : cases) {
    const std::string told = complaint(text);
    EXPECT_NE(told.find(fragment), std::string::npos) << text << "\n-> " << told;
    EXPECT_NE(told, "no error") << text;
  }
}

TEST(ReferenceTables, EveryShippedOneIsGoodAndNamedAfterItsFile) {
  std::size_t count = 0;
  for (const CorpusEntry& entry : Corpus::standard().problems()) {
    if (!entry.name.starts_with("references/")) continue;
    EXPECT_EQ(check_reference_table(entry.path).name, entry.path.stem()) << entry.path;
    ++count;
  }
  EXPECT_GE(count, 1u);
}

TEST(ReferenceTables, AreFoundWithoutTheirFolder) {
  EXPECT_EQ(find_reference_table("ibex-2.9").name, "ibex-2.9");
  EXPECT_EQ(find_reference_table("references/ibex-2.9").name, "ibex-2.9");
  const ReferenceTable one = find_reference_table("ibex-2.9:no_lp");
  EXPECT_EQ(one.methods, std::vector<std::string>{"IBEX 2.9 without LP"});
  for (const ReferenceRun& run : one.runs) EXPECT_EQ(run.method, "IBEX 2.9 without LP");
  EXPECT_NE(error_text([] { find_reference_table("ibex-2.9:no_ip"); }).find("did you mean 'no_lp'"),
            std::string::npos);
  EXPECT_NE(error_text([] { find_reference_table("ibex-2.8"); }).find("did you mean"), std::string::npos);
}

}  // namespace
}  // namespace gcslab
