#pragma once

// Random polynomials, boxes and points for tests, and exact membership in an interval.

#include <cmath>

#include "base/random.h"
#include "interval/interval.h"
#include "interval/mpfr_interval.h"
#include "polynomial/polynomial.h"
#include "polynomial/rational_box.h"

namespace gcslab {

/// A fraction with numerator up to `bound` in magnitude and denominator up to 12.
inline Rational random_fraction(Random& random, std::int64_t bound = 20) {
  return Rational(random.integer(-bound, bound)) / Rational(random.integer(1, 12));
}

/// A double whose binary exponent is uniform in [low, high].
inline Rational random_scaled(Random& random, int low, int high) {
  const double mantissa = std::ldexp(random.uniform(-1, 1), static_cast<int>(random.integer(low, high)));
  return rational_from_double(mantissa);
}

inline Exponents random_degrees(Random& random, int variables, int largest_degree) {
  Exponents degrees(static_cast<std::size_t>(variables));
  for (int& degree : degrees) degree = static_cast<int>(random.integer(0, largest_degree));
  return degrees;
}

/// About `terms` random monomials; coefficient() draws the coefficients.
template <class Coefficient>
Polynomial random_polynomial(Random& random, int variables, int largest_degree, int terms,
                             const Coefficient& coefficient) {
  Polynomial result(variables);
  for (int i = 0; i < terms; ++i)
    result.add_term(random_degrees(random, variables, largest_degree), coefficient());
  return result;
}

inline Polynomial random_polynomial(Random& random, int variables, int largest_degree, int terms) {
  return random_polynomial(random, variables, largest_degree, terms, [&] { return random_fraction(random); });
}

/// Ends are small fractions; now and then an interval is a point.
inline RationalBox random_box(Random& random, int variables) {
  RationalBox box;
  for (int i = 0; i < variables; ++i) {
    const Rational a = random_fraction(random, 9);
    const Rational b = random.below(8) == 0 ? a : random_fraction(random, 9);
    box.push_back(a < b ? RationalInterval{a, b} : RationalInterval{b, a});
  }
  return box;
}

/// A point of the unit box with dyadic or other fractions, often on its border.
inline std::vector<Rational> random_unit_point(Random& random, int variables) {
  std::vector<Rational> point;
  for (int i = 0; i < variables; ++i) {
    const std::int64_t denominator = random.integer(1, 12);
    point.push_back(Rational(random.integer(0, denominator)) / Rational(denominator));
  }
  return point;
}

/// lower + (upper - lower) t, variable by variable.
inline std::vector<Rational> point_in_box(const RationalBox& box, const std::vector<Rational>& t) {
  std::vector<Rational> point;
  for (std::size_t i = 0; i < box.size(); ++i) {
    point.emplace_back(box[i].lower + (box[i].upper - box[i].lower) * t[i]);
  }
  return point;
}

/// Exact membership.
inline bool encloses(const Interval& x, const Rational& member) {
  if (is_empty(x)) return false;
  const bool above = std::isinf(x.lower) ? x.lower < 0 : rational_from_double(x.lower) <= member;
  const bool below = std::isinf(x.upper) ? x.upper > 0 : member <= rational_from_double(x.upper);
  return above && below;
}

template <class T>
bool encloses(const T& x, const Rational& member) {
  return encloses(NumberTraits<T>::enclosure(x), member);
}

/// In the precision of its ends.
inline bool encloses(const MpfrInterval& x, const Rational& member) {
  return mpfr_cmp_q(x.lower(), member.get_mpq_t()) <= 0 && mpfr_cmp_q(x.upper(), member.get_mpq_t()) >= 0;
}

}  // namespace gcslab
