#pragma once

// All real roots of a polynomial in one variable with rational coefficients, with their multiplicities.
//
// Promise: every real root of the polynomial in the interval is listed exactly once, with its multiplicity,
// which is proved by the square-free decomposition (Yun 1976), and its closed interval contains no other real
// root in the interval of the search. All decisions are exact; double intervals only spare exact arithmetic
// where they can tell. When it is stopped, roots may also lie in the intervals that it names as unsearched.
//
// Refinement: quadratic interval refinement (Abbott 2006). It guesses by linear interpolation in which of N
// equal parts the root lies, asks the signs at both ends of that part, and takes N^2 parts next time, or
// fewer after a wrong guess.

#include <optional>
#include <vector>

#include "univariate/descartes.h"
#include "univariate/square_free.h"

namespace gcslab {

/// The reals from `lower` to `upper`; without one, the interval is unbounded on that side.
struct RealLinePart {
  std::optional<Rational> lower{};
  std::optional<Rational> upper{};
};

struct RealRoot {
  Rational lower;
  Rational upper;  ///< equal to `lower`: that is the root; else it lies strictly between them
  int multiplicity;
  std::size_t factor;  ///< of the square-free decomposition, by number

  bool is_exact() const { return lower == upper; }
};

class RealRoots {
 public:
  /// Throws NotApplicable for the zero polynomial: every number is a root of it.
  RealRoots(const IntegerPolynomial& polynomial, const RealLinePart& where, const std::stop_token& stop = {});

  /// From left to right. Their closed intervals are disjoint; ends that are no roots themselves are no roots
  /// of the polynomial.
  const std::vector<RealRoot>& roots() const { return roots_; }
  const std::vector<SquareFreeFactor>& factors() const { return factors_; }
  /// Closed intervals; empty unless it was stopped.
  const std::vector<RationalInterval>& unsearched() const { return unsearched_; }
  const IsolationCounts& counts() const { return counts_; }

  /// Narrows the interval of a root to at most that width, which is positive.
  void refine(std::size_t root, const Rational& width);
  /// Narrows it to 2^-bits of the root's magnitude; the root 0 becomes exact.
  void refine_relative(std::size_t root, int bits);
  /// Makes the root exact when it is this number.
  void try_exact(std::size_t root, const Rational& number);

 private:
  void isolate(const RealLinePart& where, const std::stop_token& stop);
  void separate();
  RealRoot with_factor(const RationalInterval& interval, const SignEvaluator& product) const;

  std::vector<SquareFreeFactor> factors_;
  std::vector<SignEvaluator> signs_;  ///< of the factors
  std::vector<RealRoot> roots_;
  std::vector<RationalInterval> unsearched_;
  IsolationCounts counts_;
};

}  // namespace gcslab
