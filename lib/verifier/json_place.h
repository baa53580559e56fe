#pragma once

// A value in a result file and where it stands, as a JSON pointer. Whatever is not as the format says throws
// Refused with that pointer.

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "interval/interval.h"
#include "verifier/refusal.h"

namespace gcslab::verifier {

class JsonPlace {
 public:
  /// `value` must outlive it.
  JsonPlace(const nlohmann::json& value, std::string pointer)
      : value_(&value), pointer_(std::move(pointer)) {}

  const nlohmann::json& value() const { return *value_; }
  const std::string& pointer() const { return pointer_; }
  [[noreturn]] void refuse(const std::string& reason) const { throw Refused(pointer_, reason); }

  /// The value of a key of an object.
  JsonPlace at(const std::string& key) const;
  std::optional<JsonPlace> find(const std::string& key) const;
  /// The values of an array.
  std::vector<JsonPlace> items() const;
  std::string text() const;
  /// A text that is one of the words.
  std::string word(const std::vector<std::string>& words) const;
  /// A finite number, plain or as hexadecimal digits in a text.
  double number() const;
  /// [lower, upper], both as texts of hexadecimal digits or inf.
  Interval interval() const;
  /// One interval a variable.
  Box box(std::size_t variables) const;

 private:
  const nlohmann::json* value_;
  std::string pointer_;
};

}  // namespace gcslab::verifier
