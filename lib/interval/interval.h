#pragma once

// Closed intervals of the extended reals as plain data, and boxes of them.
//
// An Interval is what components hand to each other: two doubles and the set operations and relations of IEEE
// 1788-2015, which need no rounding. Arithmetic lives in the number types (fast_interval.h, boost_interval.h,
// mpfr_interval.h, unrounded_interval.h, affine_form.h). The empty set is stored as [+inf, -inf]; unbounded
// intervals have infinite end points, and an end point +-inf is never itself a member.

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
bool is_empty(const Interval& x);
bool is_entire(const Interval& x);
bool is_bounded(const Interval& x);    ///< a common interval: not empty, both ends finite
bool is_singleton(const Interval& x);  ///< one member

// Relations (IEEE 1788 table 10.3); each is that standard's relation of the same name.
bool contains(const Interval& x, double member);
bool subset(const Interval& x, const Interval& y);             ///< every member of x is one of y
bool interior(const Interval& x, const Interval& y);           ///< x lies in the topological interior of y
bool disjoint(const Interval& x, const Interval& y);           ///< no common member
bool less(const Interval& x, const Interval& y);               ///< weakly less, bound by bound
bool strictly_less(const Interval& x, const Interval& y);      ///< strictly less, bound by bound
bool precedes(const Interval& x, const Interval& y);           ///< x is left of y, touching allowed
bool strictly_precedes(const Interval& x, const Interval& y);  ///< x is left of y, not touching

// Sets.
Interval intersection(const Interval& x, const Interval& y);
Interval hull(const Interval& x, const Interval& y);

// Numbers. Each gives NaN for the empty set.
double midpoint(const Interval& x);   ///< a finite member: 0 for entire, +-DBL_MAX when one end is infinite
double width(const Interval& x);      ///< upper - lower, rounded up
double radius(const Interval& x);     ///< least r with x in [midpoint - r, midpoint + r], rounded up
double magnitude(const Interval& x);  ///< largest |member|
double mignitude(const Interval& x);  ///< smallest |member|

/// "[lower, upper]" with shortest digits that round-trip, "empty", "entire".
std::string to_string(const Interval& x);

}  // namespace gcslab
