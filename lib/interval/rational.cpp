#include "interval/rational.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "base/check.h"
#include "base/error.h"
#include "interval/elementary.h"

namespace gcslab {
namespace {

/// Larger decimal exponents would make numbers that no computation can use, only memory.
constexpr long kLargestExponent = 10000;

[[noreturn]] void refuse(std::string_view text) {
  throw InputError("'" + std::string(text) + "' is not a number; write it like 2, -0.5, 1e-3 or 3/4");
}

bool all_digits(std::string_view text) {
  return std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

mpz_class power_of_ten(unsigned long exponent) {
  mpz_class result;
  mpz_ui_pow_ui(result.get_mpz_t(), 10, exponent);
  return result;
}

/// The exponent that the text after an `e` spells, for the number `whole`.
long parse_exponent(std::string_view text, std::string_view whole) {
  const bool has_plus = !text.empty() && text.front() == '+';
  if (has_plus) text.remove_prefix(1);
  if (has_plus && !text.empty() && text.front() == '-') refuse(whole);
  long exponent = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), exponent);
  if (error != std::errc() || end != text.data() + text.size()) refuse(whole);
  if (std::labs(exponent) > kLargestExponent) {
    throw InputError("the exponent of '" + std::string(whole) + "' is beyond " +
                     std::to_string(kLargestExponent) + "; write a number that a computation can use");
  }
  return exponent;
}

/// A nonnegative decimal literal: digits, an optional point, an optional exponent.
Rational parse_decimal(std::string_view text, std::string_view whole) {
  const std::size_t exponent_at = text.find_first_of("eE");
  std::string_view mantissa = text.substr(0, exponent_at);
  long exponent = exponent_at == text.npos ? 0 : parse_exponent(text.substr(exponent_at + 1), whole);
  const std::size_t point = mantissa.find('.');
  const std::string_view integer = mantissa.substr(0, point);
  const std::string_view fraction = point == mantissa.npos ? std::string_view() : mantissa.substr(point + 1);
  const std::string digits = std::string(integer) + std::string(fraction);
  if (digits.empty() || !all_digits(digits)) refuse(whole);
  exponent -= static_cast<long>(fraction.size());
  Rational value(mpz_class(digits, 10));
  const mpz_class scale = power_of_ten(static_cast<unsigned long>(std::labs(exponent)));
  if (exponent < 0) return value / scale;
  return value * scale;
}

}  // namespace

Rational rational_from_text(std::string_view text) {
  std::string_view rest = text;
  const bool negative = !rest.empty() && rest.front() == '-';
  if (!rest.empty() && (rest.front() == '-' || rest.front() == '+')) rest.remove_prefix(1);
  const std::size_t slash = rest.find('/');
  Rational value = parse_decimal(rest.substr(0, slash), text);
  if (slash != rest.npos) {
    const Rational denominator = parse_decimal(rest.substr(slash + 1), text);
    if (denominator == 0) throw InputError("'" + std::string(text) + "' divides by zero");
    value /= denominator;
  }
  return negative ? Rational(-value) : value;
}

Rational rational_from_double(double value) {
  GCSLAB_CHECK(std::isfinite(value));
  return Rational(value);
}

double nearest_double(const Rational& value) {
  const Interval around = elementary::enclosing(value);
  if (!std::isfinite(around.lower)) return around.upper;
  if (!std::isfinite(around.upper)) return around.lower;
  const Rational below = value - rational_from_double(around.lower);
  const Rational above = rational_from_double(around.upper) - value;
  if (below != above) return below < above ? around.lower : around.upper;
  const bool lower_is_even = (std::bit_cast<std::uint64_t>(around.lower) & 1) == 0;
  return lower_is_even ? around.lower : around.upper;
}

}  // namespace gcslab
