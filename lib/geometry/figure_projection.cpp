#include "geometry/figure_projection.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "expression/tape_evaluator.h"
#include "geometry/sketch.h"

namespace gcslab {
namespace {

/// Which parameters several constraints have.
std::vector<bool> shared_parameters(const ConstraintSystem& system) {
  std::vector<int> uses(system.parameters.size(), 0);
  for (const Constraint& constraint : system.constraints) {
    if (constraint.parameter) ++uses[*constraint.parameter];
  }
  std::vector<bool> result;
  for (const int count : uses) result.push_back(count > 1);
  return result;
}

/// The equations of the boolean constraints, of those that share a parameter, and those by which objects are
/// normalised. Their variables are all unknowns and parameters.
class CommonEquations {
 public:
  CommonEquations(const ConstraintSystem& system, const GeometricEquations& equations)
      : variables_(equations.unknowns.size() + equations.parameters.size()) {
    const std::vector<bool> is_shared = shared_parameters(system);
    std::vector<Expression> chosen;
    for (std::size_t k = 0; k < equations.equations.size(); ++k) {
      const std::optional<std::size_t> constraint = equations.constraint_of_equation[k];
      const auto parameter = constraint ? system.constraints[*constraint].parameter : std::nullopt;
      if (parameter && !is_shared[*parameter]) continue;
      chosen.push_back(equations.equations[k]);
      constraints_.push_back(constraint);
    }
    if (chosen.empty()) return;
    tape_.emplace(chosen, static_cast<int>(variables_));
    evaluator_.emplace(*tape_);
  }

  bool is_empty() const { return constraints_.empty(); }

  void evaluate(const std::vector<double>& point) {
    evaluator_->evaluate(point);
    const auto rows = static_cast<Eigen::Index>(constraints_.size());
    const auto columns = static_cast<Eigen::Index>(variables_);
    values_.resize(rows);
    jacobian_.resize(rows, columns);
    for (Eigen::Index k = 0; k < rows; ++k) {
      values_[k] = evaluator_->value(static_cast<std::size_t>(k));
      const auto gradient = evaluator_->reverse_gradient(static_cast<std::size_t>(k));
      for (Eigen::Index i = 0; i < columns; ++i) jacobian_(k, i) = gradient[static_cast<std::size_t>(i)];
    }
  }

  const Eigen::VectorXd& values() const { return values_; }
  const Eigen::MatrixXd& jacobian() const { return jacobian_; }
  double largest() const { return values_.cwiseAbs().maxCoeff(); }
  std::optional<std::size_t> worst_constraint() const {
    Eigen::Index worst = 0;
    values_.cwiseAbs().maxCoeff(&worst);
    return constraints_[static_cast<std::size_t>(worst)];
  }

 private:
  std::size_t variables_;
  std::vector<std::optional<std::size_t>> constraints_;
  std::optional<Tape> tape_;
  std::optional<TapeEvaluator<double>> evaluator_;
  Eigen::VectorXd values_;
  Eigen::MatrixXd jacobian_;
};

/// The distances that constraints name.
class NamedDistances {
 public:
  NamedDistances(const ConstraintSystem& system, const GeometricEquations& equations)
      : variables_(equations.unknowns.size() + equations.parameters.size()) {
    std::vector<Expression> distances;
    for (const Constraint& constraint : system.constraints) {
      if (constraint.kind->name != "distance") continue;
      ConstraintPlace place{equations.universe, {}};
      for (const std::size_t k : constraint.objects)
        place.objects.push_back(parts_of(system.objects[k].sort, equations.universe, equations.objects[k]));
      distances.push_back(constraint.kind->measure(place));
    }
    count_ = distances.size();
    if (distances.empty()) return;
    tape_.emplace(distances, static_cast<int>(variables_));
    evaluator_.emplace(*tape_);
  }

  std::vector<double> at(const std::vector<double>& point) {
    std::vector<double> result;
    if (evaluator_) evaluator_->evaluate(point);
    for (std::size_t k = 0; k < count_; ++k) result.push_back(evaluator_->value(k));
    return result;
  }

  /// A metric in which distances do not reach 0: that of the coordinates in sizes of the figure, and of each
  /// distance the part of itself by which it changes. C, lower triangular, such that a change x is as long as
  /// C^T x.
  Eigen::MatrixXd relative_metric(const std::vector<double>& point, double size) {
    const auto columns = static_cast<Eigen::Index>(variables_);
    Eigen::MatrixXd metric = Eigen::MatrixXd::Identity(columns, columns);
    const std::vector<double> distances = at(point);
    for (std::size_t k = 0; k < count_; ++k) {
      const Eigen::Map<const Eigen::VectorXd> gradient(evaluator_->reverse_gradient(k).data(), columns);
      const Eigen::VectorXd relative = size / distances[k] * gradient;
      if (relative.allFinite()) metric.selfadjointView<Eigen::Lower>().rankUpdate(relative);
    }
    return metric.llt().matrixL();
  }

 private:
  std::size_t variables_;
  std::size_t count_ = 0;
  std::optional<Tape> tape_;
  std::optional<TapeEvaluator<double>> evaluator_;
};

/// Whether some distance has all but vanished.
bool has_collapsed(const std::vector<double>& before, const std::vector<double>& after) {
  constexpr double kPart = 1e-4;
  for (std::size_t k = 0; k < before.size(); ++k) {
    if (after[k] < kPart * before[k]) return true;
  }
  return false;
}

/// The change of `count` variables from `first` on that brings the linearised equations nearest to 0, the
/// smallest one of these.
void step(CommonEquations& equations, std::vector<double>& point, std::size_t first, std::size_t count) {
  equations.evaluate(point);
  const auto columns =
      equations.jacobian().middleCols(static_cast<Eigen::Index>(first), static_cast<Eigen::Index>(count));
  if (!columns.allFinite() || !equations.values().allFinite()) return;
  const Eigen::VectorXd change = columns.completeOrthogonalDecomposition().solve(equations.values());
  for (Eigen::Index i = 0; i < change.size(); ++i) point[first + static_cast<std::size_t>(i)] -= change[i];
}

/// The same of all variables, the smallest one by the relative metric.
void relative_step(CommonEquations& equations, NamedDistances& distances, std::vector<double>& point,
                   double size) {
  equations.evaluate(point);
  if (!equations.jacobian().allFinite() || !equations.values().allFinite()) return;
  const Eigen::MatrixXd factor = distances.relative_metric(point, size);
  const Eigen::MatrixXd rows =
      factor.triangularView<Eigen::Lower>().solve(equations.jacobian().transpose()).transpose();
  Eigen::VectorXd change = rows.completeOrthogonalDecomposition().solve(equations.values());
  factor.triangularView<Eigen::Lower>().transpose().solveInPlace(change);
  for (Eigen::Index i = 0; i < change.size(); ++i) point[static_cast<std::size_t>(i)] -= change[i];
}

FigureProjection project(const ConstraintSystem& system, const GeometricEquations& equations,
                         std::vector<double> unknowns, int iterations) {
  constexpr double kExact = 1e-13;
  FigureProjection result{std::move(unknowns), true, std::nullopt};
  CommonEquations common(system, equations);
  if (common.is_empty()) return result;
  const std::size_t count = result.unknowns.size(), auxiliaries = equations.auxiliaries;
  std::vector<double> point = result.unknowns;
  const std::vector<double> parameters = parameters_of(system, figure_at(equations, point));
  point.insert(point.end(), parameters.begin(), parameters.end());
  if (auxiliaries > 0) step(common, point, count - auxiliaries, auxiliaries);
  double size = 1;
  for (const double x : point) size = std::max(size, std::abs(x));
  const auto iterate = [&](auto&& take_step) {
    for (int k = 0; k < iterations; ++k) {
      take_step();
      if (common.largest() <= kExact * size) break;
    }
  };
  NamedDistances distances(system, equations);
  const std::vector<double> drawn = point;
  iterate([&] { step(common, point, 0, point.size()); });
  if (has_collapsed(distances.at(drawn), distances.at(point))) {
    point = drawn;
    iterate([&] { relative_step(common, distances, point, size); });
  }
  common.evaluate(point);
  result.holds = common.largest() <= 1e3 * kExact * size;
  result.worst_constraint = common.worst_constraint();
  result.unknowns.assign(point.begin(), point.begin() + static_cast<std::ptrdiff_t>(count));
  return result;
}

}  // namespace

FigureProjection satisfy_common_equations(const ConstraintSystem& system, const GeometricEquations& equations,
                                          std::vector<double> unknowns) {
  constexpr int kIterations = 50;
  return project(system, equations, std::move(unknowns), kIterations);
}

FigureProjection fit_auxiliaries(const ConstraintSystem& system, const GeometricEquations& equations,
                                 std::vector<double> unknowns) {
  return project(system, equations, std::move(unknowns), 0);
}

}  // namespace gcslab
