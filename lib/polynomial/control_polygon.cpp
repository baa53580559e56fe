#include "polynomial/control_polygon.h"

#include <algorithm>
#include <vector>

#include "interval/fast_interval.h"
#include "polynomial/bernstein.h"

namespace gcslab {
namespace {

/// A point over t = index / d.
struct ControlPoint {
  double index;
  double value;
};

/// The sign of the cross product (a - o) x (b - o): positive for a turn to the left.
int orientation(const ControlPoint& o, const ControlPoint& a, const ControlPoint& b) {
  const auto difference = [](double x, double y) { return FastInterval(x) - FastInterval(y); };
  const FastInterval cross = difference(a.index, o.index) * difference(b.value, o.value) -
                             difference(a.value, o.value) * difference(b.index, o.index);
  if (cross.lower() > 0) return 1;
  if (cross.upper() < 0) return -1;
  const auto exact = [](double x, double y) {
    return Rational(rational_from_double(x) - rational_from_double(y));
  };
  return sgn(Rational(exact(a.index, o.index) * exact(b.value, o.value) -
                      exact(a.value, o.value) * exact(b.index, o.index)));
}

/// The lower convex hull of points from left to right.
std::vector<ControlPoint> lower_hull(std::span<const double> values) {
  std::vector<ControlPoint> chain;
  for (std::size_t j = 0; j < values.size(); ++j) {
    const ControlPoint next{static_cast<double>(j), values[j]};
    while (chain.size() >= 2 && orientation(chain[chain.size() - 2], chain.back(), next) <= 0)
      chain.pop_back();
    chain.push_back(next);
  }
  return chain;
}

/// Encloses the t where the segment between two points, one above the axis and one not, meets it.
FastInterval crossing(const ControlPoint& above, const ControlPoint& below, double degree) {
  const FastInterval part =
      FastInterval(above.value) / (FastInterval(above.value) - FastInterval(below.value));
  const FastInterval step = FastInterval(below.index) - FastInterval(above.index);
  return (FastInterval(above.index) + step * part) / FastInterval(degree);
}

/// Encloses the t where the lower convex hull of the values is not positive. At least two values.
Interval not_positive(std::span<const double> values) {
  const std::vector<ControlPoint> chain = lower_hull(values);
  const double degree = static_cast<double>(values.size() - 1);
  const auto is_low = [](const ControlPoint& point) { return point.value <= 0; };
  const auto first = std::ranges::find_if(chain, is_low);
  if (first == chain.end()) return Interval::empty();
  const auto last = std::ranges::find_if(chain.rbegin(), chain.rend(), is_low).base() - 1;
  const double lower = first == chain.begin() ? 0 : crossing(*(first - 1), *first, degree).lower();
  const double upper = last + 1 == chain.end() ? 1 : crossing(*(last + 1), *last, degree).upper();
  return intersection(Interval(lower, upper), Interval(0, 1));
}

}  // namespace

Interval hull_crossings(std::span<const Interval> coefficients) {
  const UpwardRounding upward;
  if (!std::ranges::all_of(coefficients, is_bounded)) return {0, 1};
  std::vector<double> lower, minus_upper;
  for (const Interval& b : coefficients) {
    lower.push_back(b.lower);
    minus_upper.push_back(-b.upper);
  }
  if (coefficients.size() == 1) return contains(coefficients.front(), 0) ? Interval(0, 1) : Interval::empty();
  return intersection(not_positive(lower), not_positive(minus_upper));
}

namespace {

/// Goes on while a step takes off at least this part of what is left.
constexpr double kLeastStep = 0.01;
constexpr int kMaximumSteps = 30;

Interval crossings_of(const BernsteinTensor<FastInterval>& part) {
  std::vector<Interval> coefficients;
  for (const FastInterval b : part.coefficients()) coefficients.push_back(b.interval());
  return hull_crossings(coefficients);
}

/// No zero lies below the result; nothing is left at all when it exceeds 1.
double first_zero(const BernsteinTensor<FastInterval>& band) {
  double lower = 0;
  for (int step = 0; step < kMaximumSteps && lower < 1; ++step) {
    const Interval found = crossings_of(band.split(0, rational_from_double(lower)).second);
    if (is_empty(found)) return 2;
    const FastInterval rest = FastInterval(1.0) - FastInterval(lower);
    const double next = (FastInterval(lower) + FastInterval(found.lower) * rest).lower();
    const bool is_worthwhile = found.lower >= kLeastStep;
    lower = std::max(lower, next);
    if (!is_worthwhile) break;
  }
  return lower;
}

/// No zero lies above the result; nothing is left at all when it is negative.
double last_zero(const BernsteinTensor<FastInterval>& band) {
  double upper = 1;
  for (int step = 0; step < kMaximumSteps && upper > 0; ++step) {
    const Interval found = crossings_of(band.split(0, rational_from_double(upper)).first);
    if (is_empty(found)) return -1;
    const bool is_worthwhile = found.upper <= 1 - kLeastStep;
    upper = std::min(upper, (FastInterval(found.upper) * FastInterval(upper)).upper());
    if (!is_worthwhile) break;
  }
  return upper;
}

}  // namespace

Interval polynomial_crossings(std::span<const Interval> coefficients) {
  const UpwardRounding upward;
  if (!std::ranges::all_of(coefficients, is_bounded)) return {0, 1};
  std::vector<FastInterval> values;
  for (const Interval& b : coefficients) values.emplace_back(b);
  const int degree = static_cast<int>(values.size()) - 1;
  const BernsteinTensor<FastInterval> band({degree}, std::move(values));
  const double lower = first_zero(band);
  const double upper = lower > 1 ? -1 : last_zero(band);
  return lower <= upper ? Interval(lower, upper) : Interval::empty();
}

}  // namespace gcslab
