#include "base/yaml_reader.h"

#include <algorithm>
#include <charconv>
#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include "base/atomic_file.h"
#include "base/nearest_name.h"

namespace gcslab {

struct YamlNode::Content {
  YAML::Node node;
  std::shared_ptr<const std::string> file;
  std::string path;  ///< "report[0].table", for messages
};

namespace {

/// Nesting beyond this is refused: no file of the project needs it, and recursion must stay bounded.
constexpr int kMaximumDepth = 64;

void check_depth(const YAML::Node& node, const std::string& file, int depth) {
  if (depth > kMaximumDepth) {
    throw InputError({file, node.Mark().line + 1},
                     fmt::format("nested deeper than {} levels", kMaximumDepth));
  }
  if (node.IsMap()) {
    for (const auto& entry : node) {
      check_depth(entry.first, file, depth + 1);
      check_depth(entry.second, file, depth + 1);
    }
  } else if (node.IsSequence()) {
    for (const auto& item : node) check_depth(item, file, depth + 1);
  }
}

template <class Number>
std::optional<Number> number_from(const std::string& text) {
  const char* begin = text.data();
  const char* end = text.data() + text.size();
  if (begin != end && *begin == '+') ++begin;
  Number number{};
  const auto [stop, error] = std::from_chars(begin, end, number);
  if (error != std::errc{} || stop != end) return std::nullopt;
  return number;
}

}  // namespace

YamlNode YamlNode::parse(const std::string& text, const std::string& file_name) {
  try {
    if (text.find('\0') != std::string::npos) throw InputError({file_name, 0}, "is no text file");
    YAML::Node root = YAML::Load(text);
    check_depth(root, file_name, 0);
    if (!root.IsDefined() || root.IsNull())
      throw InputError({file_name, 0}, "is empty; a map of keys was expected");
    return YamlNode(std::make_shared<Content>(Content{root, std::make_shared<std::string>(file_name), ""}));
  } catch (const YAML::Exception& error) {
    throw InputError({file_name, error.mark.line + 1}, "is not YAML: " + error.msg);
  }
}

YamlNode YamlNode::load_file(const std::filesystem::path& path) {
  return parse(read_file(path), path.string());
}

SourceLocation YamlNode::where() const { return {*content_->file, content_->node.Mark().line + 1}; }

void YamlNode::fail(const std::string& message) const {
  const std::string subject = content_->path.empty() ? "" : "'" + content_->path + "' ";
  throw InputError(where(), subject + message);
}

bool YamlNode::is_map() const { return content_->node.IsMap(); }
bool YamlNode::is_list() const { return content_->node.IsSequence(); }
bool YamlNode::is_scalar() const { return content_->node.IsScalar(); }
bool YamlNode::is_quoted() const { return content_->node.Tag() == "!"; }

std::string YamlNode::text() const {
  if (!is_scalar()) fail("is not a word or number");
  return content_->node.Scalar();
}

std::int64_t YamlNode::integer() const {
  const auto number = number_from<std::int64_t>(text());
  if (is_quoted() || !number) fail("is '" + text() + "'; a whole number was expected");
  return *number;
}

double YamlNode::real() const {
  const auto number = number_from<double>(text());
  if (is_quoted() || !number) fail("is '" + text() + "'; a number was expected");
  return *number;
}

bool YamlNode::flag() const {
  if (!is_quoted() && text() == "true") return true;
  if (!is_quoted() && text() == "false") return false;
  fail("is '" + text() + "'; true or false was expected");
}

std::vector<YamlNode> YamlNode::items() const {
  if (!is_list()) fail("is not a list");
  std::vector<YamlNode> result;
  for (const auto& item : content_->node) {
    const std::string path = fmt::format("{}[{}]", content_->path, result.size());
    result.push_back(YamlNode(std::make_shared<Content>(Content{item, content_->file, path})));
  }
  return result;
}

std::vector<std::string> YamlNode::texts() const {
  std::vector<std::string> result;
  for (const YamlNode& item : items()) result.push_back(item.text());
  return result;
}

std::vector<std::pair<std::string, YamlNode>> YamlNode::entries() const {
  if (!is_map()) fail("is not a map of keys");
  std::vector<std::pair<std::string, YamlNode>> result;
  for (const auto& entry : content_->node) {
    const SourceLocation key_place{*content_->file, entry.first.Mark().line + 1};
    if (!entry.first.IsScalar()) throw InputError(key_place, "a key must be a word");
    const std::string key = entry.first.Scalar();
    if (std::ranges::find(result, key, [](const auto& pair) { return pair.first; }) != result.end()) {
      throw InputError(key_place, "key '" + key + "' is given twice");
    }
    const std::string path = content_->path.empty() ? key : content_->path + "." + key;
    result.emplace_back(key,
                        YamlNode(std::make_shared<Content>(Content{entry.second, content_->file, path})));
  }
  return result;
}

void YamlNode::allow_keys(const std::vector<std::string>& known) const {
  for (const auto& [key, value] : entries()) {
    if (std::ranges::find(known, key) == known.end()) {
      throw InputError(value.where(), unknown_name_message("key", key, known));
    }
  }
}

std::optional<YamlNode> YamlNode::find(std::string_view key) const {
  for (auto& [name, value] : entries()) {
    if (name == key) return value;
  }
  return std::nullopt;
}

YamlNode YamlNode::at(std::string_view key) const {
  if (auto value = find(key)) return *value;
  fail("lacks the key '" + std::string(key) + "'");
}

}  // namespace gcslab
