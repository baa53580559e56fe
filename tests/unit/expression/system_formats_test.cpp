#include "expression/system_formats.h"

#include <filesystem>
#include <gtest/gtest.h>
#include <unistd.h>

#include "base/atomic_file.h"
#include "support/error_text.h"

namespace gcslab {
namespace {

namespace fs = std::filesystem;

class SystemFormatsTest : public testing::Test {
 protected:
  SystemFormatsTest() : folder_(fs::temp_directory_path() / ("gcslab-formats-" + std::to_string(getpid()))) {
    fs::create_directories(folder_);
  }
  ~SystemFormatsTest() override { fs::remove_all(folder_); }

  std::string file(const std::string& name, const std::string& text) const {
    write_file_atomically(folder_ / name, text);
    return folder_ / name;
  }

  fs::path folder_;
};

TEST_F(SystemFormatsTest, TheExtensionTellsTheReader) {
  const std::string minibex = "Variables x in [0, 1]; Constraints x = 1/2; end";
  EXPECT_EQ(read_system_file(file("a.bch", minibex)).box, Box{Interval(0, 1)});
  EXPECT_EQ(read_system_file(file("a.mbx", minibex)).box, Box{Interval(0, 1)});
  EXPECT_EQ(read_system_file(file("a.phc", "1\n 2*x - 1;")).box, Box{Interval::entire()});
  EXPECT_EQ(format_of_file("folder/a.phc")->name, "phc");
  EXPECT_EQ(format_of_file("a.json"), nullptr);
  EXPECT_EQ(format_of_file("a.yaml"), nullptr);
}

TEST_F(SystemFormatsTest, ErrorsNameTheFile) {
  const std::string path = file("b.phc", "1\n x - ;");
  EXPECT_EQ(error_text([&] { read_system_file(path); }),
            path + ":2: expected a number, a variable or '(', not ';'");
  EXPECT_EQ(error_text([] { read_system_file("a.txt"); }),
            "a.txt: no format reads the extension '.txt'; expected one of .phc, .bch, .mbx");
  EXPECT_NE(error_text([&] { read_system_file(folder_ / "absent.phc"); }).find("absent.phc"),
            std::string::npos);
}

TEST_F(SystemFormatsTest, EveryFormatReadsOrWrites) {
  for (const SystemFormat& format : system_formats().entries()) {
    EXPECT_TRUE(format.read != nullptr || format.write != nullptr) << format.name;
    EXPECT_FALSE(format.extensions.empty()) << format.name;
  }
  EXPECT_NE(error_text([] { system_formats().at("minbex"); }).find("'minibex'"), std::string::npos);
}

}  // namespace
}  // namespace gcslab
