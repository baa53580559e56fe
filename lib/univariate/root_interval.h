#pragma once

// Narrowing of an interval that contains one simple root, by signs.

#include "univariate/integer_polynomial.h"

namespace gcslab {

/// An open interval with exactly one root of a polynomial, which is simple; or that root itself.
class RootInterval {
 public:
  /// `signs` must outlive it. lower == upper: the root.
  RootInterval(const SignEvaluator& signs, Rational lower, Rational upper);

  const Rational& lower() const { return lower_; }
  const Rational& upper() const { return upper_; }
  Rational width() const { return upper_ - lower_; }

  /// Tells on which side of x, strictly inside, the root lies, or that it is x.
  void cut(const Rational& x);
  void bisect() { cut((lower_ + upper_) / 2); }
  /// Quadratic interval refinement to at most that width.
  void refine(const Rational& width);

 private:
  /// One of 2^bits parts that linear interpolation guesses; true when the root lies in it.
  bool take_part(unsigned long bits);

  const SignEvaluator* signs_;
  Rational lower_;
  Rational upper_;
  int sign_after_lower_;
};

}  // namespace gcslab
