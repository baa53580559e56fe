#pragma once

// Options of methods. Each is declared once, with name, meaning, unit, range and default; help texts,
// validation, error messages and `gcslab describe` follow from the declaration.

#include <cstdint>
#include <limits>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace gcslab {

/// A flag, a whole number, a real number or a word.
using OptionValue = std::variant<bool, std::int64_t, double, std::string>;

std::string to_string(const OptionValue& value);

/// The declaration of one option. The type of the default is the type of the option.
struct OptionSpec {
  std::string name;
  std::string meaning;
  OptionValue default_value;
  std::string unit{};  ///< "bits", "s", ...; empty for pure numbers and words
  double minimum = -std::numeric_limits<double>::infinity();  ///< of numbers
  double maximum = std::numeric_limits<double>::infinity();   ///< of numbers
  std::vector<std::string> choices{};                         ///< of words; empty: any word

  /// "integer in [2, 100000]", "one of fast, boost", ...
  std::string range_text() const;
};

/// A word out of a list.
OptionSpec choice_option(std::string name, std::string meaning, std::string default_choice,
                         std::vector<std::string> choices);
OptionSpec integer_option(std::string name, std::string meaning, std::string unit, std::int64_t default_value,
                          std::int64_t minimum, std::int64_t maximum);
OptionSpec real_option(std::string name, std::string meaning, std::string unit, double default_value,
                       double minimum, double maximum);
OptionSpec flag_option(std::string name, std::string meaning, bool default_value);

/// Values for a set of declared options: every declared option has one, and no other name does.
class Options {
 public:
  Options() = default;
  /// Checks `given` (texts as a user wrote them) against the declarations and fills in the defaults. `owner`
  /// names the method in errors. Throws InputError for an unknown name (with the nearest one), a wrong type
  /// or a value out of range.
  Options(std::span<const OptionSpec> declared, const std::map<std::string, std::string>& given,
          std::string_view owner);

  bool flag(std::string_view name) const { return std::get<bool>(at(name)); }
  std::int64_t integer(std::string_view name) const { return std::get<std::int64_t>(at(name)); }
  double real(std::string_view name) const { return std::get<double>(at(name)); }
  const std::string& word(std::string_view name) const { return std::get<std::string>(at(name)); }

  /// All values in order of name.
  const std::map<std::string, OptionValue, std::less<>>& values() const { return values_; }

 private:
  const OptionValue& at(std::string_view name) const;

  std::map<std::string, OptionValue, std::less<>> values_;
};

}  // namespace gcslab
