#include "homotopy/critical_point.h"

#include <Eigen/Dense>
#include <cmath>

namespace gcslab {
namespace {

using Index = Eigen::Index;

class MooreSystem {
 public:
  MooreSystem(Curve& curve, const std::vector<double>& v0)
      : curve_(&curve), m_(static_cast<Index>(curve.size())), derivatives_(curve.size(), curve.size() + 1) {
    z_.resize(2 * m_ + 2);
    z_.head(m_ + 1) = Eigen::Map<const Eigen::VectorXd>(v0.data(), m_ + 1);
    is_defined_ = evaluate(z_.head(m_ + 1));
    if (!is_defined_) return;
    // The last left singular vector; half of the digits do for a start.
    const Eigen::MatrixXd squared = jacobian() * jacobian().transpose();
    z_.segment(m_ + 1, m_) = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(squared).eigenvectors().col(0);
    z_[2 * m_ + 1] = 0;
  }

  bool is_defined() const { return is_defined_; }
  Eigen::VectorXd v() const { return z_.head(m_ + 1); }
  double gap() const { return z_[2 * m_ + 1]; }

  /// One iteration; the length of the change, infinite where none is possible.
  double step() {
    constexpr double kDifference = 1e-6;
    const Eigen::VectorXd v = z_.head(m_ + 1), w = z_.segment(m_ + 1, m_);
    const double gap = z_[2 * m_ + 1];
    const Index n = 2 * m_ + 2;
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n, n);
    Eigen::VectorXd shifted = v;
    for (Index j = 0; j <= m_; ++j) {
      shifted[j] = v[j] + kDifference;
      if (!evaluate(shifted)) return HUGE_VAL;
      shifted[j] = v[j];
      matrix.block(m_, j, m_ + 1, 1) = jacobian().transpose() * w;
    }
    if (!evaluate(v)) return HUGE_VAL;
    const Eigen::VectorXd combined = jacobian().transpose() * w;
    matrix.block(m_, 0, m_ + 1, m_ + 1).colwise() -= combined;
    matrix.block(m_, 0, m_ + 1, m_ + 1) /= kDifference;
    matrix.topLeftCorner(m_, m_ + 1) = jacobian();
    matrix.block(0, m_ + 1, m_, m_) = gap * Eigen::MatrixXd::Identity(m_, m_);
    matrix.block(0, n - 1, m_, 1) = w;
    matrix.block(m_, m_ + 1, m_ + 1, m_) = jacobian().transpose();
    matrix.block(n - 1, m_ + 1, 1, m_) = 2 * w.transpose();
    Eigen::VectorXd right(n);
    right << values_ + gap * w, combined, w.squaredNorm() - 1;
    const Eigen::VectorXd change = matrix.partialPivLu().solve(right);
    z_ -= change;
    const double length = change.norm();
    return std::isfinite(length) ? length : HUGE_VAL;
  }

 private:
  bool evaluate(const Eigen::VectorXd& v) {
    values_.resize(m_);
    const bool is_defined = curve_->jacobian({v.data(), static_cast<std::size_t>(m_) + 1},
                                             {values_.data(), static_cast<std::size_t>(m_)}, derivatives_);
    return is_defined;
  }

  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  Eigen::Map<const RowMajor> jacobian() const { return {derivatives_.data(), m_, m_ + 1}; }

  Curve* curve_;
  Index m_;
  Matrix<double> derivatives_;
  Eigen::VectorXd z_, values_;
  bool is_defined_ = false;
};

}  // namespace

std::optional<CriticalPoint> critical_point_near(Curve& curve, const std::vector<double>& v0, double radius) {
  constexpr int kIterations = 20;
  constexpr int kFirst = 3;  // that need not contract
  constexpr double kConverged = 1e-10;
  MooreSystem system(curve, v0);
  if (!system.is_defined()) return std::nullopt;
  const Eigen::VectorXd start = system.v();
  double before = HUGE_VAL;
  for (int k = 0; k < kIterations; ++k) {
    const double change = system.step();
    if (k > kFirst && !(change < before / 2) && change > kConverged) return std::nullopt;
    before = change;
    const double away = (system.v() - start).norm();
    if (!(away <= radius)) return std::nullopt;
    if (change > kConverged * (1 + start.norm())) continue;
    const Eigen::VectorXd v = system.v();
    return CriticalPoint{{v.data(), v.data() + v.size()}, std::abs(system.gap())};
  }
  return std::nullopt;
}

}  // namespace gcslab
