#include "verifier/proof_reader.h"

#include <charconv>
#include <cmath>
#include <limits>

namespace gcslab::verifier {

bool read_hexadecimal(std::string_view text, double& value) {
  const bool is_negative = text.starts_with('-');
  if (is_negative) text.remove_prefix(1);
  if (text == "inf") {
    value = std::numeric_limits<double>::infinity();
  } else {
    if (!text.starts_with("0x") || text.size() == 2 || text[2] == '-') return false;
    text.remove_prefix(2);
    const auto [end, error] =
        std::from_chars(text.data(), text.data() + text.size(), value, std::chars_format::hex);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return false;
  }
  if (is_negative) value = -value;
  return true;
}

bool ProofReader::next_line() {
  if (number_of_line_ > 0) {
    hasher_.add(line_);
    hasher_.add("\n");
  }
  position_ = 0;
  ++number_of_line_;
  return static_cast<bool>(std::getline(*stream_, line_));
}

void ProofReader::refuse(const std::string& reason) const {
  throw Refused(name_ + ":" + std::to_string(number_of_line_), reason);
}

std::string_view ProofReader::peek() const {
  const std::string_view rest = std::string_view(line_).substr(position_);
  return rest.substr(0, rest.find(' '));
}

/// Words are parted by one space each.
std::string_view ProofReader::word() {
  const std::string_view result = peek();
  if (result.empty()) refuse("the line ends early");
  position_ += result.size();
  if (position_ < line_.size()) ++position_;
  return result;
}

std::uint64_t ProofReader::integer() { return integer_from(word()); }

std::uint64_t ProofReader::integer_from(std::string_view text) const {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size())
    refuse("'" + std::string(text) + "' is no whole number");
  return value;
}

std::vector<std::size_t> ProofReader::joined_indices(std::string_view word, std::size_t limit,
                                                     const char* what) const {
  std::vector<std::size_t> result;
  while (true) {
    const std::size_t end = word.find('*');
    result.push_back(checked(integer_from(word.substr(0, end)), limit, what));
    if (end == std::string_view::npos) return result;
    word.remove_prefix(end + 1);
  }
}

void ProofReader::expect(std::string_view expected) {
  if (word() != expected) refuse("expected '" + std::string(expected) + "'");
}

std::size_t ProofReader::index(std::size_t limit, const char* what) {
  return checked(integer(), limit, what);
}

std::size_t ProofReader::checked(std::uint64_t value, std::size_t limit, const char* what) const {
  if (value >= limit) refuse("there is no " + std::string(what) + " " + std::to_string(value));
  return static_cast<std::size_t>(value);
}

double ProofReader::number() {
  const std::string_view text = word();
  double value = 0;
  if (!read_hexadecimal(text, value))
    refuse("'" + std::string(text) + "' is no number in hexadecimal digits");
  return value;
}

Interval ProofReader::interval() {
  const double lower = number();
  const double upper = number();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  if (!(lower <= upper) || lower == kInfinity || upper == -kInfinity)
    refuse("these two bounds are no interval");
  return {lower, upper};
}

Interval ProofReader::interval_or_empty() {
  if (peek() != "empty") return interval();
  word();
  return Interval::empty();
}

Box ProofReader::box(std::size_t variables) {
  Box result;
  for (std::size_t i = 0; i < variables; ++i) result.push_back(interval());
  return result;
}

void ProofReader::end_line() {
  if (!at_end_of_line()) refuse("'" + std::string(peek()) + "' is one word too many");
}

}  // namespace gcslab::verifier
