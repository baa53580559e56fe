#include "experiments/reporting/depth_shades.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fmt/format.h>
#include <vector>

#include "experiments/reporting/figure_script.h"

namespace gcslab {
namespace {

/// The colour "#rrggbb" with a part of white.
std::string tint(std::string_view colour, double white) {
  std::string result = "#";
  for (std::size_t k = 1; k < 7; k += 2) {
    const double value =
        static_cast<double>(std::strtol(std::string(colour.substr(k, 2)).c_str(), nullptr, 16));
    result += fmt::format("{:02X}", std::lround(value + white * (255 - value)));
  }
  return result;
}

}  // namespace

const Shades& edge_shades() {
  static const Shades shades = {Shade{"#B9C3CC", 0.55}, Shade{"#9AA8B5", 0.7}, Shade{"#7A8C9C", 0.85},
                                Shade{"#5A7083", 1.0},  Shade{"#38536B", 1.2}, Shade{"#143653", 1.4}};
  return shades;
}

Shades shades_of(std::string_view colour, double line_width) {
  constexpr double kPalest = 0.6;
  Shades shades;
  for (std::size_t k = 0; k < kDepths; ++k) {
    const double nearness = static_cast<double>(k) / static_cast<double>(kDepths - 1);
    shades[k] = {tint(colour, kPalest * (1 - nearness)), line_width * (0.6 + 0.4 * nearness)};
  }
  return shades;
}

DepthScale::DepthScale(double nearest, double farthest, double size)
    : nearest_(nearest), farthest_(farthest), size_(size) {}

double DepthScale::shade_at(double away) const {
  const double range = farthest_ - nearest_;
  const double nearness = range > 1e-6 * size_ ? (farthest_ - away) / range : 1;
  return nearness * static_cast<double>(kDepths);
}

std::size_t DepthScale::number_of(double shade) {
  return static_cast<std::size_t>(std::clamp(shade, 0.0, static_cast<double>(kDepths) - 0.5));
}

std::size_t veiled(std::size_t shade) {
  constexpr std::size_t kVeil = 1;
  return std::min(shade, kVeil);
}

void ShadedLines::add(const SeenPoint& from, const SeenPoint& to, bool is_hidden) {
  const double first = scale_.shade_at(from.away), last = scale_.shade_at(to.away);
  std::vector<double> cuts = {0, 1};
  for (std::size_t k = 1; k < kDepths; ++k) {
    const double t = (static_cast<double>(k) - first) / (last - first);
    if (t > 0 && t < 1) cuts.push_back(t);
  }
  std::ranges::sort(cuts);
  const double dx = to.x - from.x, dy = to.y - from.y;
  for (std::size_t i = 1; i < cuts.size(); ++i) {
    const double middle = (cuts[i - 1] + cuts[i]) / 2;
    const std::size_t shade = DepthScale::number_of(first + middle * (last - first));
    put(point_line(from.x + cuts[i - 1] * dx, from.y + cuts[i - 1] * dy),
        point_line(from.x + cuts[i] * dx, from.y + cuts[i] * dy), is_hidden ? veiled(shade) : shade);
  }
}

void ShadedLines::put(const std::string& from, const std::string& to, std::size_t shade) {
  std::string& target = lines_[shade];
  if (shade != last_shade_ || from != last_) target += (target.empty() ? "" : "\n") + from;
  target += to;
  last_shade_ = shade;
  last_ = to;
}

std::string point_line(double x, double y) { return plot_number(x) + " " + plot_number(y) + "\n"; }

}  // namespace gcslab
