#pragma once

// Ranges and tics of axes, chosen here and not by gnuplot, so that panels agree and few round numbers stand
// on each.

#include <string>
#include <utility>
#include <vector>

namespace gcslab {

struct PlotAxis {
  double low = 0;
  double high = 1;
  bool is_logarithmic = false;
  std::vector<std::pair<double, std::string>> tics;

  /// The gnuplot commands for axis 'x' or 'y'; without `numbers` the tics have no texts.
  std::string commands(char letter, bool numbers = true) const;
  /// The width of the widest number beside the axis, in millimetres.
  double widest_number() const;
};

/// A range of round numbers, with about `tics` of them, around all numbers.
PlotAxis linear_axis(const std::vector<double>& numbers, int tics = 5);

/// A range a little wider than all positive numbers; tics at powers of ten, or at 1, 2 and 5 times these
/// where fewer than two powers lie in it.
PlotAxis logarithmic_axis(const std::vector<double>& numbers);

/// An axis with a tic at each of few whole numbers, else a linear one; the range ends a little outside.
PlotAxis whole_number_axis(const std::vector<double>& numbers);

/// Exactly from `low` to `high`, with round tics inside.
PlotAxis exact_axis(double low, double high, int tics = 5);

}  // namespace gcslab
