#pragma once

// Closed intervals of the extended reals as plain data, and boxes of them.
//
// An Interval is what components hand to each other: two doubles and the set operations and relations of IEEE
// 1788-2015, which need no rounding. Arithmetic lives in the number types (fast_interval.h, boost_interval.h,
// mpfr_interval.h, unrounded_interval.h, affine_form.h). The empty set is stored as [+inf, -inf]; unbounded
// intervals have infinite end points, and an end point +-inf is never itself a member.

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace gcslab {

struct Interval {
  double lower = std::numeric_limits<double>::infinity();
  double upper = -std::numeric_limits<double>::infinity();

  /// The empty set.
  constexpr Interval() = default;
  /// The set of one number; it must be finite.
  constexpr Interval(double point) : lower(point), upper(point) {}  // NOLINT: a number is an interval
  /// {x : lower <= x <= upper}; lower <= upper must hold.
  constexpr Interval(double lower_bound, double upper_bound) : lower(lower_bound), upper(upper_bound) {}

  static constexpr Interval empty() { return {}; }
  static constexpr Interval entire() {
    return {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  }

  friend constexpr bool operator==(const Interval&, const Interval&) = default;
};

/// One interval a variable.
using Box = std::vector<Interval>;

// Kinds (IEEE 1788 section 10.5.10).
inline bool is_empty(const Interval& x) { return !(x.lower <= x.upper); }
inline bool is_entire(const Interval& x) { return x == Interval::entire(); }
/// A common interval: not empty, both ends finite.
inline bool is_bounded(const Interval& x) {
  return !is_empty(x) && std::isfinite(x.lower) && std::isfinite(x.upper);
}
inline bool is_singleton(const Interval& x) { return x.lower == x.upper; }  ///< one member

// Relations (IEEE 1788 table 10.3); each is that standard's relation of the same name.
inline bool contains(const Interval& x, double member) {
  return std::isfinite(member) && x.lower <= member && member <= x.upper;
}
/// Every member of x is one of y.
inline bool subset(const Interval& x, const Interval& y) {
  return is_empty(x) || (y.lower <= x.lower && x.upper <= y.upper);
}
bool interior(const Interval& x, const Interval& y);  ///< x lies in the topological interior of y
/// No common member.
inline bool disjoint(const Interval& x, const Interval& y) {
  return is_empty(x) || is_empty(y) || x.upper < y.lower || y.upper < x.lower;
}
bool less(const Interval& x, const Interval& y);               ///< weakly less, bound by bound
bool strictly_less(const Interval& x, const Interval& y);      ///< strictly less, bound by bound
bool precedes(const Interval& x, const Interval& y);           ///< x is left of y, touching allowed
bool strictly_precedes(const Interval& x, const Interval& y);  ///< x is left of y, not touching

// Sets.
inline Interval intersection(const Interval& x, const Interval& y) {
  if (disjoint(x, y)) return Interval::empty();
  return {x.lower < y.lower ? y.lower : x.lower, y.upper < x.upper ? y.upper : x.upper};
}
inline Interval hull(const Interval& x, const Interval& y) {
  return {y.lower < x.lower ? y.lower : x.lower, x.upper < y.upper ? y.upper : x.upper};
}

// Numbers. Each gives NaN for the empty set.
double midpoint(const Interval& x);  ///< a finite member: 0 for entire, +-DBL_MAX when one end is infinite
double width(const Interval& x);     ///< upper - lower, rounded up
double radius(const Interval& x);    ///< least r with x in [midpoint - r, midpoint + r], rounded up
/// Largest |member|.
inline double magnitude(const Interval& x) {
  if (is_empty(x)) return std::numeric_limits<double>::quiet_NaN();
  return std::fabs(x.lower) < std::fabs(x.upper) ? std::fabs(x.upper) : std::fabs(x.lower);
}
double mignitude(const Interval& x);  ///< smallest |member|

/// "[lower, upper]" with shortest digits that round-trip, "empty", "entire".
std::string to_string(const Interval& x);

}  // namespace gcslab
