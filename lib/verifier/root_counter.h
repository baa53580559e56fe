#pragma once

// Counts the real roots of one polynomial in one variable, exactly, by Sturm's theorem (1829).
//
// The chain p, p', -rem(p, p'), ... in integers, each member divided by the greatest common divisor at its
// end, changes its number of sign variations at every distinct root of p by one, and nowhere else. That
// divisor has the multiple roots of p, with multiplicities less by one; its own chain counts them, and so on.

#include <vector>

#include "interval/interval.h"
#include "verifier/integer_polynomial.h"
#include "verifier/polynomial_terms.h"

namespace gcslab::verifier {

class RootCounter {
 public:
  /// Of terms in one variable, not all 0.
  explicit RootCounter(const PolynomialTerms& terms);

  /// The number of distinct real roots in a closed interval, which may be unbounded.
  int count(const Interval& x) const { return count(0, x); }
  /// The number of distinct real roots in the union of closed intervals.
  int count_in_union(std::vector<Interval> intervals) const;
  /// The multiplicity of the only root in the interval; 0 when there is none or more than one.
  int multiplicity(const Interval& x) const;

 private:
  /// Distinct roots of multiplicity above `level`.
  int count(std::size_t level, const Interval& x) const;
  static int variations(const std::vector<IntegerPolynomial>& chain, double x);

  /// One for every multiplicity that occurs, in order; the first member of each vanishes at the roots whose
  /// multiplicity is above the index.
  std::vector<std::vector<IntegerPolynomial>> chains_;
};

}  // namespace gcslab::verifier
