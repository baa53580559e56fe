#pragma once

// "Did you mean ...?" for names that a user misspelt.

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace gcslab {

/// Number of insertions, deletions, substitutions and swaps of neighbours that turn `a` into `b` (optimal
/// string alignment distance; Damerau 1964).
std::size_t edit_distance(std::string_view a, std::string_view b);

/// The known name nearest to `name`, if it is near enough to be a misspelling of it.
std::optional<std::string> nearest_name(std::string_view name, std::span<const std::string> known);

/// "unknown method 'natrual' (did you mean 'natural'?)"; lists the known names when none is near, unless they
/// are many.
std::string unknown_name_message(std::string_view what, std::string_view name,
                                 std::span<const std::string> known);

}  // namespace gcslab
