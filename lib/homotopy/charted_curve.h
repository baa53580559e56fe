#pragma once

// A curve of figures that is described in several charts, one at a time: coordinates that are good in some
// region, where others are singular. Its size, values and points are those of the current chart.

#include <optional>

#include "homotopy/figure_curve.h"

namespace gcslab {

class ChartedCurve : public FigureCurve {
 public:
  /// Goes back to the chart in which the start was given; the start there.
  virtual const std::vector<double>& begin() = 0;
  /// Changes to another chart where that is better at v; whether it did. `is_stuck`: where nothing leads on
  /// in the current one, so that any better one will do.
  virtual bool change_at(std::span<const double> v, bool is_stuck) = 0;
  /// A point of the chart before the last change, in the current one.
  virtual std::vector<double> carried_over(std::span<const double> v) = 0;
  /// The start in the current chart; nothing where that is singular there.
  virtual std::optional<std::vector<double>> start() = 0;
  /// A point of the current chart in coordinates that depend on no chart, t the last one.
  virtual std::vector<double> chartless(std::span<const double> v) const = 0;
};

}  // namespace gcslab
