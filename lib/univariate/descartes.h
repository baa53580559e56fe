#pragma once

// Isolation of the real roots of a square-free polynomial by Descartes' rule of signs in the Bernstein basis.
//
// The number V of sign variations of the Bernstein coefficients on [u, v] is at least the number of roots in
// ]u, v[ and differs from it by an even number (Descartes 1637; in this basis Polya and Schoenberg 1958), so
// that V = 0 proves that there is none and V = 1 that there is exactly one. Intervals with more are halved by
// de Casteljau's algorithm (Lane and Riesenfeld 1981; Collins and Akritas 1976 in the power basis). For
// square-free polynomials this ends: V <= 1 when no complex root is near (Obreshkoff 1963). Coefficients are
// double intervals; an interval where their signs do not tell V is converted exactly and goes on from there.

#include <cstdint>
#include <stop_token>
#include <vector>

#include "polynomial/rational_box.h"
#include "univariate/integer_polynomial.h"

namespace gcslab {

/// How much work an isolation was.
struct IsolationCounts {
  std::uint64_t intervals = 0;          ///< whose sign variations were counted
  std::uint64_t halvings = 0;           ///< of them cut in two
  std::uint64_t exact_conversions = 0;  ///< of them where doubles could not tell
};

struct RootIsolation {
  /// From left to right: the root itself (lower = upper), or an open interval that contains exactly one root.
  /// These are disjoint, but may have a root as an end.
  std::vector<RationalInterval> roots;
  std::vector<RationalInterval> unsearched;  ///< closed; empty unless it was stopped
  IsolationCounts counts;
};

/// The distinct real roots of a square-free polynomial in the closed interval.
RootIsolation isolate_square_free(const IntegerPolynomial& polynomial, const RationalInterval& where,
                                  const std::stop_token& stop = {});

/// An interval ]-bound, bound[ with bound a power of 2 that contains every complex root's modulus (Fujiwara
/// 1916): 2 max |a_k / a_d|^(1 / (d - k)). The degree is 1 at least.
Rational root_bound(const IntegerPolynomial& polynomial);

}  // namespace gcslab
