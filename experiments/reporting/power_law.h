#pragma once

// y = factor * x^exponent through points, by least squares of the logarithms.

#include <optional>
#include <utility>
#include <vector>

namespace gcslab {

struct PowerLaw {
  double factor = 0;
  double exponent = 0;
  double from = 0, to = 0;  ///< the x between which it was fitted

  double at(double x) const;
};

/// Fits the points in the upper half of the logarithmic range of x, where lower order terms weigh least.
/// Points with a number that has no logarithm do not count; nothing without three different x.
std::optional<PowerLaw> fitted_power_law(const std::vector<std::pair<double, double>>& points);

}  // namespace gcslab
