#include "experiments/reporting/plane_drawing.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <utility>

#include "experiments/reporting/figure_script.h"

namespace gcslab {
namespace {

constexpr double kLongestAspect = 3;
/// What the curve is simplified to, as a share of the domain: 0.02 mm in a panel of 80 mm.
constexpr double kCurveTolerance = 1.0 / 4000;

double distance_to_line(const Point& p, const Point& a, const Point& b) {
  const double dx = b[0] - a[0];
  const double dy = b[1] - a[1];
  const double length = std::hypot(dx, dy);
  if (length == 0) return std::hypot(p[0] - a[0], p[1] - a[1]);
  return std::abs(dx * (p[1] - a[1]) - dy * (p[0] - a[0])) / length;
}

}  // namespace

double panel_aspect(const Box& domain) {
  const double aspect = (domain[1].upper - domain[1].lower) / (domain[0].upper - domain[0].lower);
  return aspect > kLongestAspect || aspect < 1 / kLongestAspect ? 1 : aspect;
}

Polyline simplified(const Polyline& line, double tolerance) {
  if (line.size() < 3) return line;
  std::vector<bool> keep(line.size(), false);
  keep.front() = keep.back() = true;
  std::vector<std::pair<std::size_t, std::size_t>> open = {{0, line.size() - 1}};
  while (!open.empty()) {
    const auto [first, last] = open.back();
    open.pop_back();
    std::size_t farthest = first;
    double distance = tolerance;
    for (std::size_t i = first + 1; i < last; ++i) {
      const double d = distance_to_line(line[i], line[first], line[last]);
      if (d > distance) {
        distance = d;
        farthest = i;
      }
    }
    if (farthest == first) continue;
    keep[farthest] = true;
    open.emplace_back(first, farthest);
    open.emplace_back(farthest, last);
  }
  Polyline result;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (keep[i]) result.push_back(line[i]);
  }
  return result;
}

std::string curve_lines(const std::vector<Polyline>& curve, const Box& domain) {
  const double tolerance =
      kCurveTolerance * std::max(domain[0].upper - domain[0].lower, domain[1].upper - domain[1].lower);
  std::string lines;
  for (const Polyline& line : curve) {
    if (!lines.empty()) lines += "\n";
    for (const Point& p : simplified(line, tolerance))
      lines += plot_number(p[0]) + " " + plot_number(p[1]) + "\n";
  }
  return lines;
}

std::string axis_commands(const Box& domain, bool vertical_tics) {
  std::string lines;
  for (const auto& [variable, letter] : {std::pair{0U, 'x'}, std::pair{1U, 'y'}}) {
    const Interval& side = domain[variable];
    lines += fmt::format("set {}range [{}:{}]\n", letter, side.lower, side.upper);
    const char* format = letter == 'x' || vertical_tics ? "%.3g" : "";
    lines += fmt::format("set format {} '{}'\n", letter, format);
    lines += fmt::format("set {}tics ({}, {}, {})\n", letter, side.lower, midpoint(side), side.upper);
  }
  lines.pop_back();
  return lines;
}

}  // namespace gcslab
