#pragma once

// Names of variables across languages that forbid different ones.

#include <functional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace gcslab {

/// A variable name of our language (parser.h) that is not in `taken`, as like `wanted` as possible:
/// characters that it must not have become underscores, and underscores are added until it is free. Adds it
/// to `taken`.
std::string free_variable_name(std::string_view wanted, std::set<std::string>& taken);

/// Variables under names that another language allows.
struct ForeignNames {
  std::vector<std::string> names;                            ///< one a variable, different from each other
  std::vector<std::pair<std::string, std::string>> renamed;  ///< new and old names of those that changed
};

/// Keeps every allowed name; others get v_ in front. `is_allowed` must allow nearly every name of that form.
ForeignNames foreign_names(std::span<const std::string> variables,
                           const std::function<bool(const std::string&)>& is_allowed);

}  // namespace gcslab
