#pragma once

// The verifier's own arithmetic: intervals of two MPFR numbers of 256 bits.
//
// Promise: every operation encloses {op(a, b) : a in x, b in y, op defined at (a, b)}; its ends are the exact
// ones rounded outward, at most a few units wider for rational powers and beside the extrema of sin and cos.
// It shares no code with the number types of the solvers, so that a fault of theirs cannot confirm itself.
// The precision is fixed: rounding outward to 256 bits lies inside rounding outward to 53, so that whatever a
// solver finds in doubles by a formula, the same formula finds here. NaN breaks an invariant.

#include <array>
#include <mpfr.h>

#include "interval/interval.h"
#include "interval/rational.h"

namespace gcslab::verifier {

inline constexpr int kBits = 256;

/// An MPFR number of kBits bits that needs no memory beside itself.
class Real {
 public:
  /// Zero.
  Real() { mpfr_custom_init_set(value_, MPFR_ZERO_KIND, 0, kBits, limbs_.data()); }
  explicit Real(double value) : Real() { mpfr_set_d(value_, value, MPFR_RNDN); }
  Real(const Real& other) : limbs_(other.limbs_) { take(other); }
  Real& operator=(const Real& other) {
    limbs_ = other.limbs_;
    take(other);
    return *this;
  }
  ~Real() = default;

  mpfr_ptr get() { return value_; }
  mpfr_srcptr get() const { return value_; }

 private:
  void take(const Real& other) {
    *value_ = *other.value_;
    mpfr_custom_move(value_, limbs_.data());
  }

  mpfr_t value_;
  std::array<mp_limb_t, (kBits + GMP_NUMB_BITS - 1) / GMP_NUMB_BITS> limbs_{};
};

/// A closed set of reals between two ends; an end +-inf is no member.
class Range {
 public:
  /// {0}.
  Range() = default;
  Range(double point) : lower_(point), upper_(point) {}  // NOLINT: a number is a range
  explicit Range(const Interval& x) : lower_(x.lower), upper_(x.upper) {}
  explicit Range(const Rational& value);
  explicit Range(const Real& point) : lower_(point), upper_(point) {}

  static Range empty() { return Range(Interval::empty()); }
  static Range entire() { return Range(Interval::entire()); }
  static Range pi();

  mpfr_ptr lower() { return lower_.get(); }
  mpfr_ptr upper() { return upper_.get(); }
  const Real& lower_end() const { return lower_; }
  const Real& upper_end() const { return upper_; }
  mpfr_srcptr lower() const { return lower_.get(); }
  mpfr_srcptr upper() const { return upper_.get(); }

  /// The empty set is [+inf, -inf].
  bool is_empty() const;
  bool is_positive() const { return !is_empty() && mpfr_sgn(lower()) > 0; }
  bool is_zero() const { return mpfr_zero_p(lower()) != 0 && mpfr_zero_p(upper()) != 0; }
  bool is_bounded() const { return mpfr_number_p(lower()) != 0 && mpfr_number_p(upper()) != 0; }
  bool contains_zero() const { return mpfr_sgn(lower()) <= 0 && mpfr_sgn(upper()) >= 0; }
  /// Every member is one of x.
  bool is_within(const Interval& x) const;
  bool is_within(const Range& x) const;
  /// The same, and the ends of x are none of them.
  bool is_inside(const Range& x) const;
  bool is_disjoint_from(const Range& x) const;
  /// The ends rounded outward to double.
  Interval outward() const;

 private:
  Real lower_;
  Real upper_;
};

Range operator-(const Range& x);
Range operator+(const Range& x, const Range& y);
Range operator-(const Range& x, const Range& y);
Range operator*(const Range& x, const Range& y);
Range operator/(const Range& x, const Range& y);
/// factor * x.
Range scaled(double factor, const Range& x);
Range sqr(const Range& x);
/// x^exponent; for an odd denominator also of negative numbers, as cbrt is.
Range power(const Range& x, const Rational& exponent);
Range sqrt(const Range& x);
Range cbrt(const Range& x);
Range exp(const Range& x);
Range log(const Range& x);
Range sin(const Range& x);
Range cos(const Range& x);
Range tan(const Range& x);
Range asin(const Range& x);
Range acos(const Range& x);
Range atan(const Range& x);
Range abs(const Range& x);
Range min(const Range& x, const Range& y);
Range max(const Range& x, const Range& y);

Range intersection(const Range& x, const Range& y);
/// The smallest range around both.
Range hull(const Range& x, const Range& y);
/// A number near the middle of a bounded range; 0 for others.
Real middle(const Range& x);
/// An upper bound of |member|.
Real magnitude(const Range& x);

}  // namespace gcslab::verifier
