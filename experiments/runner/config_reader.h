#pragma once

// Small readers that the parts of a config share.

#include <string>
#include <string_view>
#include <vector>

#include "base/nearest_name.h"
#include "base/yaml_reader.h"

namespace gcslab {

/// The items of a list that is not empty; a single word stands for the list of itself.
inline std::vector<YamlNode> one_or_more(const YamlNode& node) {
  if (node.is_scalar()) return {node};
  std::vector<YamlNode> items = node.items();
  if (items.empty()) node.fail("is an empty list");
  return items;
}

/// Runs `read`; an input error of it, which knows no line, gets the line of `node`.
template <class Read>
auto at_place(const YamlNode& node, Read read) {
  try {
    return read();
  } catch (const InputError& error) {
    throw InputError(node.where(), error.what());
  }
}

/// A word that is one of `known`.
inline std::string known_word(const YamlNode& node, std::string_view what,
                              const std::vector<std::string>& known) {
  std::string word = node.text();
  for (const std::string& name : known) {
    if (name == word) return word;
  }
  throw InputError(node.where(), unknown_name_message(what, word, known));
}

/// A word that can name a file or folder on every system: letters, digits, '.', '_', '-', no leading '.'.
std::string file_name_word(const YamlNode& node);

}  // namespace gcslab
