#pragma once

// A registry is an explicit list of variants, written in one file a family: a new variant is one line there.

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/check.h"
#include "base/error.h"
#include "base/nearest_name.h"

namespace gcslab {

/// Entries have a member `name`, unique in the registry. `what` names the family in error messages ("bound").
template <class Entry>
class Registry {
 public:
  Registry(std::string what, std::vector<Entry> entries)
      : what_(std::move(what)), entries_(std::move(entries)) {
    for (auto entry = entries_.begin(); entry != entries_.end(); ++entry) {
      GCSLAB_CHECK(
          std::none_of(entries_.begin(), entry, [&](const Entry& e) { return e.name == entry->name; }));
    }
  }

  const std::vector<Entry>& entries() const { return entries_; }

  /// The entry of that name, or nullptr.
  const Entry* find(std::string_view name) const {
    const auto found =
        std::find_if(entries_.begin(), entries_.end(), [&](const Entry& e) { return e.name == name; });
    return found == entries_.end() ? nullptr : &*found;
  }

  /// The entry of that name. Throws InputError that proposes the nearest name.
  const Entry& at(std::string_view name) const {
    if (const Entry* entry = find(name)) return *entry;
    throw InputError(unknown_name_message(what_, name, names()));
  }

  std::vector<std::string> names() const {
    std::vector<std::string> result;
    for (const Entry& entry : entries_) result.emplace_back(entry.name);
    return result;
  }

 private:
  std::string what_;
  std::vector<Entry> entries_;
};

}  // namespace gcslab
