#include "base/option.h"

#include <algorithm>
#include <charconv>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <optional>

#include "base/check.h"
#include "base/error.h"
#include "base/nearest_name.h"

namespace gcslab {
namespace {

template <class Number>
std::optional<Number> whole_text_as(std::string_view text) {
  Number number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return number;
}

bool in_range(const OptionSpec& spec, double number) {
  return spec.minimum <= number && number <= spec.maximum;
}

/// The value that `text` spells for the type of the option, if it does and lies in the range.
std::optional<OptionValue> parse(const OptionSpec& spec, const std::string& text) {
  if (std::holds_alternative<bool>(spec.default_value)) {
    if (text == "true") return true;
    if (text == "false") return false;
    return std::nullopt;
  }
  if (std::holds_alternative<std::int64_t>(spec.default_value)) {
    const auto number = whole_text_as<std::int64_t>(text);
    if (!number || !in_range(spec, static_cast<double>(*number))) return std::nullopt;
    return *number;
  }
  if (std::holds_alternative<double>(spec.default_value)) {
    const auto number = whole_text_as<double>(text);
    if (!number || !in_range(spec, *number)) return std::nullopt;
    return *number;
  }
  const bool allowed = spec.choices.empty() || std::ranges::find(spec.choices, text) != spec.choices.end();
  return allowed ? std::optional<OptionValue>(text) : std::nullopt;
}

std::string range_suffix(const OptionSpec& spec) {
  const bool below = spec.minimum > -std::numeric_limits<double>::infinity();
  const bool above = spec.maximum < std::numeric_limits<double>::infinity();
  if (below && above) return fmt::format(" in [{}, {}]", spec.minimum, spec.maximum);
  if (below) return fmt::format(" >= {}", spec.minimum);
  if (above) return fmt::format(" <= {}", spec.maximum);
  return "";
}

}  // namespace

std::string to_string(const OptionValue& value) {
  if (const bool* flag = std::get_if<bool>(&value)) return *flag ? "true" : "false";
  if (const auto* integer = std::get_if<std::int64_t>(&value)) return std::to_string(*integer);
  if (const double* real = std::get_if<double>(&value)) return fmt::format("{}", *real);
  return std::get<std::string>(value);
}

std::string OptionSpec::range_text() const {
  if (std::holds_alternative<bool>(default_value)) return "true or false";
  if (std::holds_alternative<std::int64_t>(default_value)) return "integer" + range_suffix(*this);
  if (std::holds_alternative<double>(default_value)) return "number" + range_suffix(*this);
  return choices.empty() ? "text" : fmt::format("one of {}", fmt::join(choices, ", "));
}

OptionSpec choice_option(std::string name, std::string meaning, std::string default_choice,
                         std::vector<std::string> choices) {
  OptionSpec spec{std::move(name), std::move(meaning), std::move(default_choice)};
  spec.choices = std::move(choices);
  return spec;
}

OptionSpec integer_option(std::string name, std::string meaning, std::string unit, std::int64_t default_value,
                          std::int64_t minimum, std::int64_t maximum) {
  return {std::move(name), std::move(meaning),           default_value,
          std::move(unit), static_cast<double>(minimum), static_cast<double>(maximum)};
}

OptionSpec real_option(std::string name, std::string meaning, std::string unit, double default_value,
                       double minimum, double maximum) {
  return {std::move(name), std::move(meaning), default_value, std::move(unit), minimum, maximum};
}

OptionSpec flag_option(std::string name, std::string meaning, bool default_value) {
  return {std::move(name), std::move(meaning), default_value};
}

Options::Options(std::span<const OptionSpec> declared, const std::map<std::string, std::string>& given,
                 std::string_view owner) {
  std::vector<std::string> names;
  for (const OptionSpec& spec : declared) {
    names.push_back(spec.name);
    values_.emplace(spec.name, spec.default_value);
  }
  for (const auto& [name, text] : given) {
    const auto spec = std::ranges::find(declared, name, &OptionSpec::name);
    if (spec == declared.end()) {
      throw InputError(unknown_name_message(fmt::format("option of {}", owner), name, names));
    }
    const auto value = parse(*spec, text);
    if (!value) {
      throw InputError(
          fmt::format("option '{}' of {} is '{}'; expected {}", name, owner, text, spec->range_text()));
    }
    values_.insert_or_assign(name, *value);
  }
}

const OptionValue& Options::at(std::string_view name) const {
  const auto found = values_.find(name);
  GCSLAB_CHECK(found != values_.end());
  return found->second;
}

}  // namespace gcslab
