#include "local_search/newton_raphson.h"

#include <Eigen/QR>
#include <cmath>
#include <optional>

#include "interval/rounding.h"
#include "local_search/residuals.h"

namespace gcslab {
namespace {

/// Pivots below this part of the largest, rows scaled to 1, tell nothing but rounding errors.
constexpr double kSingular = 1e-13;

/// J^-1 f; nothing where the Jacobian is singular.
std::optional<Eigen::VectorXd> newton_step(const Residuals& residuals) {
  const Eigen::VectorXd scales = residuals.jacobian().rowwise().lpNorm<Eigen::Infinity>();
  if (scales.minCoeff() == 0) return std::nullopt;
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> factors;
  factors.setThreshold(kSingular);
  factors.compute(scales.cwiseInverse().asDiagonal() * residuals.jacobian());
  if (!factors.isInvertible()) return std::nullopt;
  return factors.solve(residuals.values().cwiseQuotient(scales));
}

std::vector<double> moved(const std::vector<double>& point, const Eigen::VectorXd& step, double part) {
  std::vector<double> result = point;
  for (std::size_t i = 0; i < point.size(); ++i) result[i] -= part * step[static_cast<Eigen::Index>(i)];
  return result;
}

/// The longest of the step, its half, quarter and so on that lets the sum of squares fall as Armijo asks;
/// nothing when none does.
std::optional<std::vector<double>> damped(Residuals& residuals, const std::vector<double>& point,
                                          const Eigen::VectorXd& step) {
  constexpr double kSufficient = 1e-4;
  constexpr int kHalvings = 40;
  const double before = residuals.values().squaredNorm();
  for (int halvings = 0; halvings <= kHalvings; ++halvings) {
    const double part = std::ldexp(1, -halvings);
    std::vector<double> next = moved(point, step, part);
    if (residuals.sum_of_squares(next) <= (1 - 2 * kSufficient * part) * before) return next;
  }
  return std::nullopt;
}

bool is_finite(const std::vector<double>& point) {
  return Eigen::Map<const Eigen::VectorXd>(point.data(), static_cast<Eigen::Index>(point.size())).allFinite();
}

}  // namespace

LocalSearch newton_raphson(const SystemFunctions& functions, std::vector<double> start,
                           const NewtonRaphsonOptions& options, const std::stop_token& stop) {
  const NearestRounding nearest;
  Residuals residuals(functions, start);
  LocalSearch search;
  search.point = std::move(start);
  const auto ended = [&](LocalSearchEnd end) {
    search.end = end;
    search.residual = residuals.largest();
    return search;
  };
  for (;; ++search.iterations) {
    if (!residuals.evaluate(search.point))
      return ended(is_finite(search.point) ? LocalSearchEnd::undefined : LocalSearchEnd::diverged);
    if (residuals.relative() <= options.tolerance) return ended(LocalSearchEnd::root);
    if (stop.stop_requested()) return ended(LocalSearchEnd::stopped);
    if (search.iterations == options.maximum_iterations) return ended(LocalSearchEnd::budget);
    const std::optional<Eigen::VectorXd> step = newton_step(residuals);
    if (!step) return ended(LocalSearchEnd::singular);
    std::optional<std::vector<double>> next =
        options.is_damped ? damped(residuals, search.point, *step) : moved(search.point, *step, 1);
    if (!next) return ended(LocalSearchEnd::stalled);
    search.point = std::move(*next);
  }
}

}  // namespace gcslab
