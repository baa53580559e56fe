#include "interval/interval.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "interval/rounding.h"

namespace gcslab {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kLargest = std::numeric_limits<double>::max();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// The standard's <': < but true also between equal infinities.
bool inside_below(double x, double y) { return x < y || (x == y && std::isinf(x)); }

double difference_up(double x, double y) {
  const UpwardRounding upward;
  return rounded_subtract(x, y);
}

std::string shortest(double value) {
  std::array<char, 32> text{};
  const auto result = std::to_chars(text.data(), text.data() + text.size(), value == 0 ? 0.0 : value);
  return {text.data(), result.ptr};
}

}  // namespace

bool interior(const Interval& x, const Interval& y) {
  return is_empty(x) || (inside_below(y.lower, x.lower) && inside_below(x.upper, y.upper));
}

bool less(const Interval& x, const Interval& y) {
  if (is_empty(x) || is_empty(y)) return is_empty(x) && is_empty(y);
  return x.lower <= y.lower && x.upper <= y.upper;
}

bool strictly_less(const Interval& x, const Interval& y) {
  if (is_empty(x) || is_empty(y)) return is_empty(x) && is_empty(y);
  return inside_below(x.lower, y.lower) && inside_below(x.upper, y.upper);
}

bool precedes(const Interval& x, const Interval& y) {
  return is_empty(x) || is_empty(y) || x.upper <= y.lower;
}

bool strictly_precedes(const Interval& x, const Interval& y) {
  return is_empty(x) || is_empty(y) || x.upper < y.lower;
}

double midpoint(const Interval& x) {
  if (is_empty(x)) return kNaN;
  if (is_entire(x)) return 0;
  if (x.lower == -kInfinity) return -kLargest;
  if (x.upper == kInfinity) return kLargest;
  const NearestRounding nearest;
  const double sum = rounded_add(x.lower, x.upper);
  if (std::isfinite(sum)) return rounded_multiply(0.5, sum);
  return rounded_add(0.5 * x.lower, 0.5 * x.upper);
}

double width(const Interval& x) { return is_empty(x) ? kNaN : difference_up(x.upper, x.lower); }

double radius(const Interval& x) {
  if (is_empty(x)) return kNaN;
  const double centre = midpoint(x);
  return std::max(difference_up(x.upper, centre), difference_up(centre, x.lower));
}

double mignitude(const Interval& x) {
  if (is_empty(x)) return kNaN;
  if (x.lower <= 0 && x.upper >= 0) return 0;
  return std::min(std::fabs(x.lower), std::fabs(x.upper));
}

std::string to_string(const Interval& x) {
  if (is_empty(x)) return "empty";
  if (is_entire(x)) return "entire";
  return "[" + shortest(x.lower) + ", " + shortest(x.upper) + "]";
}

}  // namespace gcslab
