#include "certification/newton_iteration.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "interval/point_numbers.h"

namespace gcslab {
namespace {

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

Eigen::Map<const RowMajor> as_eigen(const Matrix<double>& matrix) {
  return {matrix.data(), static_cast<Eigen::Index>(matrix.rows()),
          static_cast<Eigen::Index>(matrix.columns())};
}

}  // namespace

std::optional<Matrix<double>> approximate_inverse(const Matrix<double>& matrix) {
  const NearestRounding nearest;
  const RowMajor inverse = as_eigen(matrix).inverse();
  if (!inverse.allFinite()) return std::nullopt;
  Matrix<double> result(matrix.rows(), matrix.columns());
  std::copy_n(inverse.data(), matrix.rows() * matrix.columns(), result.data());
  return result;
}

NewtonIteration::NewtonIteration(const SystemFunctions& functions, std::vector<double> scales)
    : scales_(std::move(scales)),
      evaluator_(functions),
      values_(functions.variables()),
      jacobian_(functions.variables(), functions.variables()) {}

double NewtonIteration::reach(std::size_t variable, const Interval& side) const {
  return std::max(radius(side), 1e-8 * std::max(scales_[variable], magnitude(side)));
}

bool NewtonIteration::stays_near(const Box& box, std::span<const double> point) const {
  for (std::size_t i = 0; i < box.size(); ++i) {
    const double slack = reach(i, box[i]);
    if (!(point[i] >= box[i].lower - slack && point[i] <= box[i].upper + slack)) return false;
  }
  return true;
}

std::optional<double> NewtonIteration::step(const Box& box, std::vector<double>& point) {
  evaluator_.values(point, values_);
  if (!evaluator_.jacobian(point, jacobian_)) return std::nullopt;
  const Eigen::Map<const Eigen::VectorXd> f(values_.data(), static_cast<Eigen::Index>(values_.size()));
  const Eigen::VectorXd change = as_eigen(jacobian_).partialPivLu().solve(f);
  if (!change.allFinite()) return std::nullopt;
  double largest = 0;
  for (std::size_t i = 0; i < point.size(); ++i) {
    const double move = change[static_cast<Eigen::Index>(i)];
    point[i] -= move;
    largest = std::max(largest, std::fabs(move) / reach(i, box[i]));
  }
  if (!stays_near(box, point)) return std::nullopt;
  return largest;
}

std::optional<ApproximateRoot> NewtonIteration::run(const Box& box) {
  const NearestRounding nearest;
  constexpr int kMaximumSteps = 20;
  ApproximateRoot root;
  for (const Interval& side : box) root.point.push_back(midpoint(side));
  double previous = std::numeric_limits<double>::infinity();
  for (int i = 0; i < kMaximumSteps; ++i) {
    const std::optional<double> moved = step(box, root.point);
    if (!moved) return std::nullopt;
    // Quadratic convergence ends where rounding begins: the steps no longer shrink.
    if (*moved == 0 || (*moved < 1e-3 && *moved >= previous / 2)) break;
    if (i >= 5 && *moved > previous / 2) return std::nullopt;
    previous = *moved;
  }
  if (!evaluator_.jacobian(root.point, jacobian_)) return std::nullopt;
  std::optional<Matrix<double>> inverse = approximate_inverse(jacobian_);
  if (!inverse) return std::nullopt;
  root.inverse = std::move(*inverse);
  return root;
}

}  // namespace gcslab
