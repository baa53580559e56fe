#pragma once

// Exact rational numbers: the constants of every expression, and the oracle of many tests.

#include <gmpxx.h>
#include <string>
#include <string_view>

namespace gcslab {

/// An exact rational in lowest terms with positive denominator.
using Rational = mpq_class;

/// The rational that a decimal or fraction spells, exactly: "0.1" is 1/10, "1e-3" is 1/1000, "3/4" is 3/4.
/// Throws InputError for a text that is no number.
Rational rational_from_text(std::string_view text);

/// The rational that equals a finite double. Infinities and NaN break the invariant.
Rational rational_from_double(double value);

/// The finite double nearest to the value, ties to even.
double nearest_double(const Rational& value);

}  // namespace gcslab
