#include "base/yaml_reader.h"

#include <gtest/gtest.h>

namespace gcslab {
namespace {

std::string message_of(const std::string& text, void (*use)(const YamlNode&)) {
  try {
    use(YamlNode::parse(text, "file.yaml"));
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(YamlReader, DuplicateKeysAreRefusedWithTheirLine) {
  EXPECT_EQ(message_of("a: 1\nb: 2\na: 3\n", [](const YamlNode& root) { root.entries(); }),
            "file.yaml:3: key 'a' is given twice");
}

TEST(YamlReader, UnknownKeysGetTheNearestKnownOne) {
  EXPECT_EQ(message_of("a: 1\nmehtods: 2\n",
                       [](const YamlNode& root) {
                         root.allow_keys({"a", "methods"});
                       }),
            "file.yaml:2: unknown key 'mehtods' (did you mean 'methods'?)");
}

TEST(YamlReader, NumbersAreDecimalAndQuotedTextStaysText) {
  const YamlNode root = YamlNode::parse("a: 010\nb: \"no\"\nc: +2.5\n", "file.yaml");
  EXPECT_EQ(root.at("a").integer(), 10);
  EXPECT_EQ(root.at("b").text(), "no");
  EXPECT_DOUBLE_EQ(root.at("c").real(), 2.5);
  EXPECT_EQ(message_of("b: \"3\"", [](const YamlNode& n) { n.at("b").integer(); }),
            "file.yaml:1: 'b' is '3'; a whole number was expected");
  EXPECT_EQ(message_of("b: yes", [](const YamlNode& n) { n.at("b").flag(); }),
            "file.yaml:1: 'b' is 'yes'; true or false was expected");
}

TEST(YamlReader, MissingKeysAndPathsAreNamed) {
  EXPECT_EQ(message_of("a:\n  - b: 1\n", [](const YamlNode& n) { n.at("a").items()[0].at("c"); }),
            "file.yaml:2: 'a[0]' lacks the key 'c'");
}

TEST(YamlReader, HostileTextIsAnInputError) {
  EXPECT_NE(message_of("a: [1, 2", [](const YamlNode&) {}).find("file.yaml:"), std::string::npos);
  EXPECT_EQ(message_of("", [](const YamlNode&) {}), "file.yaml: is empty; a map of keys was expected");
  const std::string deep = std::string(200, '[') + std::string(200, ']');
  EXPECT_NE(message_of(deep, [](const YamlNode&) {}).find("nested deeper"), std::string::npos);
}

}  // namespace
}  // namespace gcslab
