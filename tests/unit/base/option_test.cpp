#include "base/option.h"

#include <gtest/gtest.h>

#include "base/error.h"

namespace gcslab {
namespace {

const std::vector<OptionSpec> kSpecs = {
    choice_option("arithmetic", "which", "fast", {"fast", "boost"}),
    integer_option("bits", "precision", "bits", 53, 2, 1000),
    real_option("tolerance", "relative", "", 1e-9, 0, 1),
    flag_option("record", "keep a record", false),
};

std::string message_of(const std::map<std::string, std::string>& given) {
  try {
    const Options options(kSpecs, given, "natural");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Options, DefaultsAreFilledIn) {
  const Options options(kSpecs, {{"bits", "100"}}, "natural");
  EXPECT_EQ(options.integer("bits"), 100);
  EXPECT_EQ(options.word("arithmetic"), "fast");
  EXPECT_DOUBLE_EQ(options.real("tolerance"), 1e-9);
  EXPECT_FALSE(options.flag("record"));
}

TEST(Options, BadValuesNameOptionOwnerAndRange) {
  EXPECT_EQ(message_of({{"bits", "1"}}), "option 'bits' of natural is '1'; expected integer in [2, 1000]");
  EXPECT_EQ(message_of({{"bits", "12x"}}),
            "option 'bits' of natural is '12x'; expected integer in [2, 1000]");
  EXPECT_EQ(message_of({{"arithmetic", "fats"}}),
            "option 'arithmetic' of natural is 'fats'; expected one of fast, boost");
  EXPECT_EQ(message_of({{"record", "yes"}}), "option 'record' of natural is 'yes'; expected true or false");
  EXPECT_EQ(message_of({{"tolerance", "nan"}}),
            "option 'tolerance' of natural is 'nan'; expected number in [0, 1]");
}

TEST(Options, MisspeltNamesGetTheNearest) {
  EXPECT_EQ(message_of({{"arithmetc", "fast"}}),
            "unknown option of natural 'arithmetc' (did you mean 'arithmetic'?)");
}

}  // namespace
}  // namespace gcslab
