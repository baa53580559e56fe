#pragma once

// Numbers as tables and figures print them, in UTF-8: "1,234", "0.0123", "1.2×10⁻¹²". Writers translate what
// their format spells differently.

#include <string>
#include <string_view>
#include <vector>

namespace gcslab {

/// A whole number with thousands separators.
std::string format_count(double number);

/// `digits` significant digits, whole parts never rounded away ("1,234"); a power of ten below 10^-4 and from
/// 10^7 on.
std::string format_significant(double number, int digits);

/// A whole number as a count, any other with `digits` significant digits; "inf", "-inf", "nan" as such.
std::string format_number(double number, int digits = 3);

/// What numbers of one column are multiplied by, and the unit they then have.
struct Scale {
  double factor = 1;
  std::string unit;
};

/// The unit in which numbers of the given unit are shortest: seconds become ns, µs, ms or s. One unit for
/// them all, so that they can be compared at a glance.
Scale scale_for(std::string_view unit, const std::vector<double>& numbers);

/// The text with the typographic minus sign in place of each hyphen.
std::string with_minus_sign(std::string_view text);

/// The power-of-ten exponent in superscript characters.
std::string superscript(int exponent);

}  // namespace gcslab
