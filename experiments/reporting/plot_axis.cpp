#include "experiments/reporting/plot_axis.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <set>

#include "experiments/reporting/escape.h"
#include "experiments/reporting/figure_script.h"
#include "experiments/reporting/number_format.h"

namespace gcslab {
namespace {

std::vector<double> finite_ones(const std::vector<double>& numbers, bool positive) {
  std::vector<double> result;
  for (const double number : numbers) {
    if (std::isfinite(number) && (!positive || number > 0)) result.push_back(number);
  }
  return result;
}

/// 1, 2 or 5 times a power of ten, nearest to `wanted` from above.
double round_step(double wanted) {
  const double power = std::pow(10.0, std::floor(std::log10(wanted)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= wanted * (1 - 1e-9)) return factor * power;
  }
  return 10 * power;
}

std::string tic_text(double value, int decimals) {
  if (decimals > 5 || std::abs(value) >= 1e7) return fmt::format("{:.3g}", value);
  return decimals == 0 ? format_count(value) : fmt::format("{:.{}f}", value, decimals);
}

/// Multiples of `step` in [low, high]. Their texts have as many decimals as the step needs.
std::vector<std::pair<double, std::string>> multiples(double low, double high, double step) {
  const int decimals = std::max(0, static_cast<int>(-std::floor(std::log10(step) + 1e-9)));
  std::vector<std::pair<double, std::string>> tics;
  const double slack = 1e-9 * step;
  for (double k = std::ceil((low - slack) / step); k * step <= high + slack; ++k) {
    const double value = k == 0 ? 0 : k * step;
    tics.emplace_back(value, tic_text(value, decimals));
  }
  return tics;
}

/// All powers of an axis read alike: plain numbers when all are short.
std::string power_text(int exponent, bool plain) {
  if (!plain) return "10" + superscript(exponent);
  const double power = std::pow(10.0, exponent);
  return exponent >= 0 ? format_count(power) : fmt::format("{:.{}f}", power, -exponent);
}

std::vector<std::pair<double, std::string>> powers(int first, int last) {
  constexpr int kMost = 7;
  const int stride = std::max(1, (last - first + kMost - 1) / kMost);
  std::vector<std::pair<double, std::string>> tics;
  for (int exponent = first; exponent <= last; exponent += stride) {
    tics.emplace_back(std::pow(10.0, exponent), power_text(exponent, first >= -2 && last <= 4));
  }
  return tics;
}

/// The numbers 1, 2 and 5 times powers of ten from `low` to `high`.
std::vector<double> one_two_five(double low, double high) {
  std::vector<double> result;
  const int last = static_cast<int>(std::floor(std::log10(high)));
  for (int exponent = static_cast<int>(std::floor(std::log10(low))); exponent <= last; ++exponent) {
    for (const double factor : {1.0, 2.0, 5.0}) {
      const double value = factor * std::pow(10.0, exponent);
      if (value >= low * (1 - 1e-9) && value <= high * (1 + 1e-9)) result.push_back(value);
    }
  }
  return result;
}

}  // namespace

std::string PlotAxis::commands(char letter, bool numbers) const {
  std::string list;
  for (const auto& [value, words] : tics) {
    list += fmt::format("{}{} {}", list.empty() ? "" : ", ",
                        gnuplot_string(numbers ? with_minus_sign(words) : ""), plot_number(value));
  }
  return fmt::format("{} logscale {}\nset {}range [{}:{}]\nset {}tics ({})", is_logarithmic ? "set" : "unset",
                     letter, letter, low, high, letter, list);
}

double PlotAxis::widest_number() const {
  double widest = 0;
  for (const auto& [value, words] : tics) widest = std::max(widest, text_width(words));
  return widest;
}

PlotAxis exact_axis(double low, double high, int tics) {
  if (!(high > low)) return {low - 0.5, low + 0.5, false, {{low, plot_number(low)}}};
  return {low, high, false, multiples(low, high, round_step((high - low) / tics))};
}

PlotAxis linear_axis(const std::vector<double>& numbers, int tics) {
  const std::vector<double> finite = finite_ones(numbers, false);
  if (finite.empty()) return exact_axis(0, 1, tics);
  auto [least, greatest] = std::ranges::minmax(finite);
  if (least == greatest) {
    const double room = least == 0 ? 1 : std::abs(least) / 2;
    least -= room;
    greatest += room;
  }
  const double step = round_step((greatest - least) / tics);
  const double low = std::floor(least / step + 1e-9) * step;
  const double high = std::ceil(greatest / step - 1e-9) * step;
  return {low, high, false, multiples(low, high, step)};
}

PlotAxis logarithmic_axis(const std::vector<double>& numbers) {
  constexpr double kRoom = 1.2;
  const std::vector<double> positive = finite_ones(numbers, true);
  if (positive.empty()) return {0.1, 1, true, powers(-1, 0)};
  const auto [least, greatest] = std::ranges::minmax(positive);
  PlotAxis axis{least / kRoom, greatest * kRoom, true, {}};
  const int first = static_cast<int>(std::ceil(std::log10(axis.low)));
  const int last = static_cast<int>(std::floor(std::log10(axis.high)));
  axis.tics = powers(first, last);
  if (axis.tics.size() >= 2) return axis;
  axis.tics.clear();
  for (const double value : one_two_five(axis.low, axis.high))
    axis.tics.emplace_back(value, format_significant(value, 1));
  return axis;
}

PlotAxis whole_number_axis(const std::vector<double>& numbers) {
  constexpr std::size_t kMost = 10;
  const std::set<double> distinct(numbers.begin(), numbers.end());
  const bool whole =
      std::ranges::all_of(distinct, [](double n) { return n == std::floor(n) && std::abs(n) < 1e6; });
  if (distinct.empty() || !whole) return linear_axis(numbers);
  const double room = std::max(0.5, 0.03 * (*distinct.rbegin() - *distinct.begin()));
  PlotAxis axis{*distinct.begin() - room, *distinct.rbegin() + room, false, {}};
  if (distinct.size() > kMost) {
    axis.tics = multiples(axis.low, axis.high, std::max(1.0, round_step((axis.high - axis.low) / 6)));
    return axis;
  }
  for (const double value : distinct) axis.tics.emplace_back(value, fmt::format("{:.0f}", value));
  return axis;
}

}  // namespace gcslab
