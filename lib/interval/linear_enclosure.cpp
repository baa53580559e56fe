#include "interval/linear_enclosure.h"

#include <algorithm>
#include <cmath>

namespace gcslab {
namespace {

std::optional<LinearEnclosure> usable(double slope, const Interval& offset) {
  if (!std::isfinite(slope) || !is_bounded(offset)) return std::nullopt;
  return LinearEnclosure{slope, offset};
}

/// f(point) - slope * point.
FastInterval residual(const UnivariateFunction& f, double slope, double point) {
  return f.value(FastInterval(point)) - FastInterval(slope) * FastInterval(point);
}

double secant_slope(const UnivariateFunction& f, const Interval& x) {
  const double low = midpoint(f.value(FastInterval(x.lower)).interval());
  const double high = midpoint(f.value(FastInterval(x.upper)).interval());
  return (high - low) / (x.upper - x.lower);
}

/// For convex f, f - slope x is largest at an end of x and lies above each of its tangents. The proof holds
/// for any slope and tangent point; the secant's slope and the tangent parallel to it make the band narrow.
/// Concave f: mirrored.
std::optional<LinearEnclosure> enclose_parallel_to_secant(const UnivariateFunction& f, const Interval& x,
                                                          bool convex) {
  const double slope = secant_slope(f, x);
  if (!std::isfinite(slope)) return std::nullopt;
  const double guess = f.tangent_point(slope, x);
  const double touching = std::isnan(guess) ? midpoint(x) : std::clamp(guess, x.lower, x.upper);
  const FastInterval at_ends = hull(residual(f, slope, x.lower), residual(f, slope, x.upper));
  const FastInterval tangent_slope = f.derivative(FastInterval(touching)) - FastInterval(slope);
  const FastInterval steps = FastInterval(x) - FastInterval(touching);
  const FastInterval on_tangent = residual(f, slope, touching) + tangent_slope * steps;
  if (convex) return usable(slope, {on_tangent.lower(), at_ends.upper()});
  return usable(slope, {at_ends.lower(), on_tangent.upper()});
}

/// With the slope that is the derivative's bound nearest 0, f - slope x is monotone, so that its ends bound
/// it.
std::optional<LinearEnclosure> enclose_with_least_range(const UnivariateFunction& f, const Interval& x) {
  const Interval derivative = f.derivative(FastInterval(x)).interval();
  if (is_empty(derivative) || (derivative.lower < 0 && derivative.upper > 0)) return std::nullopt;
  const bool grows = derivative.lower >= 0;
  const double slope = grows ? derivative.lower : derivative.upper;
  if (!std::isfinite(slope)) return std::nullopt;
  const FastInterval at_lower = residual(f, slope, x.lower);
  const FastInterval at_upper = residual(f, slope, x.upper);
  return usable(slope, {(grows ? at_lower : at_upper).lower(), (grows ? at_upper : at_lower).upper()});
}

}  // namespace

std::optional<LinearEnclosure> enclose_linearly(const UnivariateFunction& f, const Interval& x,
                                                Approximation approximation) {
  const Curvature curvature = approximation == Approximation::min_range ? Curvature::mixed : f.curvature(x);
  if (curvature == Curvature::mixed) return enclose_with_least_range(f, x);
  return enclose_parallel_to_secant(f, x, curvature == Curvature::convex);
}

std::optional<LinearEnclosure> enclose_absolute_value(const Interval& x, Approximation approximation) {
  if (x.lower >= 0) return LinearEnclosure{1, 0};
  if (x.upper <= 0) return LinearEnclosure{-1, 0};
  if (approximation == Approximation::min_range) return std::nullopt;
  // The slope is that of a line that supports |x| at 0, so that |x| - slope x is never negative.
  const double slope = std::clamp((x.upper + x.lower) / (x.upper - x.lower), -1.0, 1.0);
  const auto at = [slope](double end) {
    return FastInterval(std::fabs(end)) - FastInterval(slope) * FastInterval(end);
  };
  return usable(slope, {0, hull(at(x.lower), at(x.upper)).upper()});
}

}  // namespace gcslab
