#include "enclosure/dyadic_slack.h"

#include <algorithm>
#include <cmath>

#include "polynomial/exact_conversion.h"

namespace gcslab {
namespace {

/// The exponent of the lowest set bit of a nonzero dyadic rational.
long lowest_bit(const Rational& value) {
  return static_cast<long>(mpz_scan1(value.get_num_mpz_t(), 0)) -
         static_cast<long>(mpz_scan1(value.get_den_mpz_t(), 0));
}

/// Whether lower + j (upper - lower) / 2^depth is a double for all j in 0 .. 2^depth.
bool ends_are_exact(const Interval& side, int depth) {
  const Rational lower = rational_from_double(side.lower);
  const Rational extent = rational_from_double(side.upper) - lower;
  if (extent == 0) return true;
  const long of_extent = lowest_bit(extent) - depth;
  const long grid = lower == 0 ? of_extent : std::min(lowest_bit(lower), of_extent);
  const int exponent = std::ilogb(magnitude(side));
  constexpr long kSmallestBit = -1074;
  constexpr long kBits = 53;
  return grid >= kSmallestBit && exponent + 1 - grid <= kBits;
}

/// A bound of the distance between a computed end and the exact one. Each halving adds at most one rounding
/// of a number that is at most the magnitude of the side: less than twice its last place.
Rational end_error(const Interval& side, int depth) {
  const long exponent = std::max(std::ilogb(magnitude(side)) - 52, -1074) + 1L;
  const Rational halvings(depth);
  return exponent >= 0 ? Rational(halvings << static_cast<unsigned long>(exponent))
                       : Rational(halvings >> static_cast<unsigned long>(-exponent));
}

/// max |f| over the box.
Rational magnitude_bound(const Polynomial& polynomial, const RationalBox& box) {
  const Tensor<Rational> tensor = exact_bernstein_coefficients(polynomial, box);
  Rational bound = 0;
  for (const Rational& coefficient : tensor.coefficients()) {
    bound = std::max<Rational>(bound, abs(coefficient));
  }
  return bound;
}

}  // namespace

Rational dyadic_slack(const Polynomial& polynomial, const Box& domain, int depth) {
  Rational slack = 0;
  for (std::size_t i = 0; i < domain.size(); ++i) {
    if (ends_are_exact(domain[i], depth)) continue;
    const Polynomial partial = polynomial.derivative(static_cast<int>(i));
    slack += magnitude_bound(partial, rational_box(domain)) * end_error(domain[i], depth);
  }
  return slack;
}

}  // namespace gcslab
