#include "local_search/residuals.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gcslab {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double size_of(std::span<const double> point) {
  double size = 0;
  for (const double x : point) size = std::max(size, std::abs(x));
  return size;
}

}  // namespace

Residuals::Residuals(const SystemFunctions& functions, std::span<const double> start)
    : evaluator_(functions),
      values_(functions.equations().size()),
      other_(functions.equations().size()),
      jacobian_(functions.equations().size(), functions.variables()),
      start_size_(size_of(start)) {}

bool Residuals::evaluate(std::span<const double> point) {
  size_ = std::max(size_of(point), start_size_);
  evaluator_.values(point, values_);
  return evaluator_.jacobian(point, jacobian_) && values().allFinite() && jacobian().allFinite();
}

double Residuals::sum_of_squares(std::span<const double> point) {
  evaluator_.values(point, other_);
  double sum = 0;
  for (const double value : other_) sum += value * value;
  return std::isfinite(sum) ? sum : kInfinity;
}

Eigen::Map<const Eigen::VectorXd> Residuals::values() const {
  return {values_.data(), static_cast<Eigen::Index>(values_.size())};
}

Eigen::Map<const Residuals::RowMajor> Residuals::jacobian() const {
  return {jacobian_.data(), static_cast<Eigen::Index>(jacobian_.rows()),
          static_cast<Eigen::Index>(jacobian_.columns())};
}

double Residuals::largest() const { return values().cwiseAbs().maxCoeff<Eigen::PropagateNaN>(); }

double Residuals::relative() const {
  double largest = 0;
  for (Eigen::Index i = 0; i < values().size(); ++i) {
    const double value = std::abs(values()[i]);
    if (value > 0) largest = std::max(largest, value / (jacobian().row(i).cwiseAbs().maxCoeff() * size_));
  }
  return largest;
}

bool Residuals::is_stationary() const {
  constexpr double kSmall = 1e-4;
  const Eigen::VectorXd gradient = 2 * jacobian().transpose() * values();
  return gradient.lpNorm<Eigen::Infinity>() * size_ <= kSmall * values().squaredNorm();
}

}  // namespace gcslab
