#include "homotopy/corrector.h"

#include <algorithm>
#include <cmath>

namespace gcslab {

Corrector::Corrector(Curve& curve, const CorrectorOptions& options)
    : curve_(&curve),
      options_(options),
      matrix_(curve.pattern()),
      values_(curve.size()),
      zero_(curve.size(), 0.0),
      change_(curve.size() + 1),
      kernel_(curve.size() + 1),
      jacobian_(curve.size(), curve.size() + 1) {}

bool Corrector::factorise(const std::vector<double>& v, std::span<const double> border) {
  return curve_->jacobian(v, values_, jacobian_) && matrix_.factorise(jacobian_, border);
}

Correction Corrector::correct(const CurvePoint& here, const BorderedMatrix& at_here, double step,
                              std::vector<double>& v) {
  if (options_.kind == CorrectorKind::chord) {
    predicted_ = v;
    const Correction correction = iterate(here, &at_here, step, v);
    if (correction.end != Correction::End::no_contraction) return correction;
    v = predicted_;
  }
  return iterate(here, nullptr, step, v);
}

/// With the matrix of the last point, or a new one an iteration.
Correction Corrector::iterate(const CurvePoint& here, const BorderedMatrix* at_here, double step,
                              std::vector<double>& v) {
  constexpr double kLargestRate = 0.5;
  constexpr double kOfStep = 0.01, kOfStepPolished = 0.0002;
  constexpr double kRounding = 1e-14;
  Correction result;
  double before = 0;
  for (int k = 0; k < options_.iterations; ++k) {
    if (at_here != nullptr) {
      if (!curve_->values(v, values_)) return {Correction::End::undefined};
      at_here->solve(values_, 0, change_);
    } else {
      if (!factorise(v, here.tangent)) return {Correction::End::undefined};
      matrix_.solve(values_, 0, change_);
      if (options_.kind == CorrectorKind::normal_flow) {
        matrix_.solve(zero_, 1, kernel_);
        const double along = dot(change_, kernel_) / dot(kernel_, kernel_);
        for (std::size_t i = 0; i < change_.size(); ++i) change_[i] -= along * kernel_[i];
      }
    }
    const double change = norm(change_);
    if (k == 0) result.first = change;
    const double rate = k > 0 ? change / before : 1;
    if (k > 0) result.rate = std::max(result.rate, rate);
    if (!std::isfinite(change) || result.rate > kLargestRate) break;
    for (std::size_t i = 0; i < v.size(); ++i) v[i] -= change_[i];
    const double size = 1 + largest(v);
    double tolerance = std::max(std::min(options_.tolerance * size, kOfStep * step), kRounding * size);
    if (options_.is_polished_after)
      tolerance = std::max(tolerance, std::min(std::sqrt(tolerance * step / rate), kOfStepPolished * step));
    // What is left is at most a geometric series. One small change alone says little: beyond a sharp turn all
    // are small, and none leads to the curve.
    if (change <= kRounding * size || (rate < 1 && change * rate <= (1 - rate) * tolerance)) return result;
    before = change;
  }
  result.end = Correction::End::no_contraction;
  return result;
}

}  // namespace gcslab
