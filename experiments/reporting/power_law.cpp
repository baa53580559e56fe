#include "experiments/reporting/power_law.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace gcslab {

double PowerLaw::at(double x) const { return factor * std::pow(x, exponent); }

std::optional<PowerLaw> fitted_power_law(const std::vector<std::pair<double, double>>& points) {
  std::vector<std::pair<double, double>> logarithms;
  for (const auto& [x, y] : points) {
    if (x > 0 && y > 0) logarithms.emplace_back(std::log(x), std::log(y));
  }
  if (logarithms.empty()) return std::nullopt;
  const auto [least, most] = std::ranges::minmax(logarithms);
  const double middle = (least.first + most.first) / 2;
  std::erase_if(logarithms, [&](const auto& point) { return point.first < middle; });
  std::set<double> different;
  double mean_x = 0, mean_y = 0;
  const auto count = static_cast<double>(logarithms.size());
  for (const auto& [x, y] : logarithms) {
    different.insert(x);
    mean_x += x / count;
    mean_y += y / count;
  }
  if (different.size() < 3) return std::nullopt;
  double xx = 0, xy = 0;
  for (const auto& [x, y] : logarithms) {
    xx += (x - mean_x) * (x - mean_x);
    xy += (x - mean_x) * (y - mean_y);
  }
  const double exponent = xy / xx;
  return PowerLaw{std::exp(mean_y - exponent * mean_x), exponent, std::exp(*different.begin()),
                  std::exp(*different.rbegin())};
}

}  // namespace gcslab
