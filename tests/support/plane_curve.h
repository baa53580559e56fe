#pragma once

// Curves in the plane of x and t, given by an equation in any number type, for tests.

#include <array>
#include <cmath>

#include "homotopy/interval_curve.h"
#include "interval/point_numbers.h"

namespace gcslab {

/// `function(x, t)` returns H and its derivatives by x and by t, for doubles and for FastInterval.
template <class Function>
class PlaneCurve final : public Curve, public IntervalCurve {
 public:
  explicit PlaneCurve(Function function) : function_(std::move(function)) {}

  std::size_t size() const override { return 1; }

  bool values(std::span<const double> v, std::span<double> result) override {
    result[0] = function_(v[0], v[1])[0];
    return std::isfinite(result[0]);
  }
  bool jacobian(std::span<const double> v, std::span<double> result, Matrix<double>& derivatives) override {
    const auto [h, by_x, by_t] = function_(v[0], v[1]);
    result[0] = h;
    derivatives(0, 0) = by_x;
    derivatives(0, 1) = by_t;
    return std::isfinite(h) && std::isfinite(by_x) && std::isfinite(by_t);
  }

  bool values(std::span<const FastInterval> v, std::span<FastInterval> result) override {
    result[0] = function_(v[0], v[1])[0];
    return true;
  }
  bool jacobian(std::span<const FastInterval> v, Matrix<FastInterval>& result) override {
    const auto [h, by_x, by_t] = function_(v[0], v[1]);
    static_cast<void>(h);
    result(0, 0) = by_x;
    result(0, 1) = by_t;
    return true;
  }

 private:
  Function function_;
};

/// x^2 + t^2 = 4.
inline auto circle() {
  return PlaneCurve([]<class T>(const T& x, const T& t) {
    return std::array<T, 3>{x * x + t * t - T(4), T(2) * x, T(2) * t};
  });
}

/// Ovals of Cassini around (0, 1/2) with y = 2 t - 1: (x^2 + y^2)^2 - 4 (y^2 - x^2) + gap = 0; for gap = 0
/// the lemniscate.
inline auto ovals(double gap) {
  return PlaneCurve([gap]<class T>(const T& x, const T& t) {
    const T y = T(2) * t - T(1), s = x * x + y * y;
    return std::array<T, 3>{s * s - T(4) * (y * y - x * x) + T(gap), T(4) * x * s + T(8) * x,
                            T(2) * (T(4) * y * s - T(8) * y)};
  });
}

/// x of the ovals at t = 0.
inline double oval_start(double gap) { return std::sqrt(std::sqrt(12.0 - gap) - 3); }

}  // namespace gcslab
