#include "experiments/reporting/number_format.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

namespace gcslab {
namespace {

constexpr double kSmallest = 1e-4;
constexpr double kLargest = 1e7;

/// Puts separators into the digits before the decimal point.
std::string with_separators(std::string text) {
  const std::size_t first = text.starts_with('-') ? 1 : 0;
  std::size_t point = text.find('.');
  if (point == std::string::npos) point = text.size();
  for (std::size_t at = point; at > first + 3;) {
    at -= 3;
    text.insert(at, ",");
  }
  return text;
}

std::string in_power_of_ten(double number, int digits) {
  const std::string text = fmt::format("{:.{}e}", number, digits - 1);
  const std::size_t mark = text.find('e');
  return text.substr(0, mark) + "×10" + superscript(std::stoi(text.substr(mark + 1)));
}

/// The middle of the nonzero magnitudes, or 0.
double typical_magnitude(const std::vector<double>& numbers) {
  std::vector<double> magnitudes;
  for (const double number : numbers) {
    if (number != 0 && std::isfinite(number)) magnitudes.push_back(std::abs(number));
  }
  if (magnitudes.empty()) return 0;
  const auto middle = magnitudes.begin() + static_cast<std::ptrdiff_t>(magnitudes.size() / 2);
  std::nth_element(magnitudes.begin(), middle, magnitudes.end());
  return *middle;
}

}  // namespace

std::string with_minus_sign(std::string_view text) {
  std::string result;
  for (const char c : text) c == '-' ? result += "−" : result += c;
  return result;
}

std::string superscript(int exponent) {
  static constexpr std::array<std::string_view, 10> kDigits = {"⁰", "¹", "²", "³", "⁴",
                                                               "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = exponent < 0 ? "⁻" : "";
  for (const char digit : std::to_string(std::abs(exponent)))
    text += kDigits[static_cast<std::size_t>(digit - '0')];
  return text;
}

std::string format_count(double number) { return with_separators(fmt::format("{:.0f}", number)); }

std::string format_significant(double number, int digits) {
  if (number == 0) return "0";
  const double magnitude = std::abs(number);
  if (magnitude < kSmallest || magnitude >= kLargest) return in_power_of_ten(number, digits);
  // The exponent of the rounded number: 9.996 with three digits is 10.0.
  const std::string rounded = fmt::format("{:.{}e}", number, digits - 1);
  const int exponent = std::stoi(rounded.substr(rounded.find('e') + 1));
  return with_separators(fmt::format("{:.{}f}", number, std::max(0, digits - 1 - exponent)));
}

std::string format_number(double number, int digits) {
  if (!std::isfinite(number)) return fmt::format("{}", number);
  const bool is_whole = number == std::floor(number) && std::abs(number) < 1e15;
  return is_whole ? format_count(number) : format_significant(number, digits);
}

Scale scale_for(std::string_view unit, const std::vector<double>& numbers) {
  if (unit != "s") return {1, std::string(unit)};
  const double typical = typical_magnitude(numbers);
  if (typical == 0 || typical >= 1) return {1, "s"};
  if (typical >= 1e-3) return {1e3, "ms"};
  if (typical >= 1e-6) return {1e6, "µs"};
  return {1e9, "ns"};
}

}  // namespace gcslab
