#pragma once

// MpfrInterval: intervals of two MPFR numbers, of any precision.
//
// Promise: every operation encloses the exact set of results, and its ends are the exact ones rounded outward
// to the precision of the innermost Scope alive in the thread (53 bits without one). Rational powers with a
// denominator, and integer ones beyond 2^31, enclose but may be a unit wider. The exponent range is MPFR's,
// so that what overflows a double does not here. Semantics are elementary.h's and FastInterval's: natural
// domains, empty and unbounded intervals.

#include <mpfr.h>
#include <utility>

#include "interval/interval.h"
#include "interval/number_traits.h"
#include "interval/rational.h"

namespace gcslab {

/// Owns one MPFR number. A moved-from number may only be assigned to or destroyed.
class MpfrNumber {
 public:
  /// NaN in the precision of the active scope.
  MpfrNumber();
  /// NaN in a given precision.
  explicit MpfrNumber(mpfr_prec_t precision);
  /// A copy in the precision of the original.
  explicit MpfrNumber(mpfr_srcptr value);
  MpfrNumber(const MpfrNumber& other);
  MpfrNumber(MpfrNumber&& other) noexcept;
  MpfrNumber& operator=(MpfrNumber other) noexcept;
  ~MpfrNumber();

  mpfr_ptr get() { return value_; }
  mpfr_srcptr get() const { return value_; }

 private:
  mpfr_t value_;
};

class MpfrInterval {
 public:
  /// The empty set, in the precision of the active scope.
  MpfrInterval() : MpfrInterval(Interval::empty()) {}
  /// The interval rounded outward to the precision of the active scope.
  explicit MpfrInterval(const Interval& x);
  MpfrInterval(MpfrNumber lower, MpfrNumber upper) : lower_(std::move(lower)), upper_(std::move(upper)) {}

  mpfr_srcptr lower() const { return lower_.get(); }
  mpfr_srcptr upper() const { return upper_.get(); }
  /// The empty set is [+inf, -inf].
  bool is_empty() const { return mpfr_lessequal_p(lower(), upper()) == 0; }
  /// The ends rounded outward to double.
  Interval interval() const;

 private:
  MpfrNumber lower_;
  MpfrNumber upper_;
};

MpfrInterval operator-(const MpfrInterval& x);
MpfrInterval operator+(const MpfrInterval& x, const MpfrInterval& y);
MpfrInterval operator-(const MpfrInterval& x, const MpfrInterval& y);
MpfrInterval operator*(const MpfrInterval& x, const MpfrInterval& y);
MpfrInterval operator/(const MpfrInterval& x, const MpfrInterval& y);
MpfrInterval sqr(const MpfrInterval& x);
MpfrInterval pow(const MpfrInterval& x, int n);
MpfrInterval pow(const MpfrInterval& x, const Rational& exponent);
MpfrInterval sqrt(const MpfrInterval& x);
MpfrInterval cbrt(const MpfrInterval& x);
MpfrInterval exp(const MpfrInterval& x);
MpfrInterval log(const MpfrInterval& x);
MpfrInterval sin(const MpfrInterval& x);
MpfrInterval cos(const MpfrInterval& x);
MpfrInterval tan(const MpfrInterval& x);
MpfrInterval asin(const MpfrInterval& x);
MpfrInterval acos(const MpfrInterval& x);
MpfrInterval atan(const MpfrInterval& x);
MpfrInterval abs(const MpfrInterval& x);
MpfrInterval min(const MpfrInterval& x, const MpfrInterval& y);
MpfrInterval max(const MpfrInterval& x, const MpfrInterval& y);

template <>
struct NumberTraits<MpfrInterval> {
  /// Sets the precision of results in this thread to `bits`, at least 2.
  class Scope {
   public:
    explicit Scope(int bits = 53);
    ~Scope();
    Scope(const Scope&) = delete;
    Scope& operator=(const Scope&) = delete;

   private:
    mpfr_prec_t saved_;
  };
  static MpfrInterval from_rational(const Rational& value);
  static MpfrInterval from_interval(const Interval& x) { return MpfrInterval(x); }
  static MpfrInterval pi();
  static Interval enclosure(const MpfrInterval& x) { return x.interval(); }
  static constexpr Promise promise = Promise::rigorous;
  static constexpr bool is_set = true;
};

}  // namespace gcslab
