#pragma once

// The one strict loader of YAML: nothing that a user writes is silently ignored, repeated or reinterpreted.
//
// Duplicate and unknown keys are refused with file, line and the nearest known key. Numbers are decimal (010
// is ten), "quoted" scalars are text, and flags are exactly true and false.

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/error.h"

namespace gcslab {

/// A node of a YAML document that knows where it stands. All accessors throw InputError with file and line
/// when the node is not what was asked for.
class YamlNode {
 public:
  static YamlNode load_file(const std::filesystem::path& path);
  static YamlNode parse(const std::string& text, const std::string& file_name);

  SourceLocation where() const;
  [[noreturn]] void fail(const std::string& message) const;

  bool is_map() const;
  bool is_list() const;
  bool is_scalar() const;
  /// True for a scalar in quotes, which is text whatever it spells.
  bool is_quoted() const;

  std::string text() const;
  std::int64_t integer() const;
  double real() const;
  bool flag() const;

  std::vector<YamlNode> items() const;
  /// The texts of a list of scalars.
  std::vector<std::string> texts() const;
  std::vector<std::pair<std::string, YamlNode>> entries() const;

  /// Refuses every key of this map that is not in the list.
  void allow_keys(const std::vector<std::string>& known) const;
  std::optional<YamlNode> find(std::string_view key) const;
  /// The entry of a key that must be there.
  YamlNode at(std::string_view key) const;

 private:
  struct Content;
  explicit YamlNode(std::shared_ptr<const Content> content) : content_(std::move(content)) {}

  std::shared_ptr<const Content> content_;
};

}  // namespace gcslab
