#include "local_search/sum_of_squares.h"

#include <algorithm>
#include <ceres/ceres.h>
#include <cmath>
#include <glog/logging.h>
#include <limits>

#include "interval/rounding.h"
#include "local_search/residuals.h"

namespace gcslab {
namespace {

/// The system as Ceres sees it: unknowns in units of the start's size, equations in units of their largest
/// change on such a way, since its tolerances and first steps suppose numbers near 1.
class ScaledResiduals {
 public:
  ScaledResiduals(const SystemFunctions& functions, const std::vector<double>& start)
      : residuals_(functions, start), point_(start) {
    for (const double x : start) length_ = std::max(length_, std::abs(x));
    if (length_ == 0) length_ = 1;
    is_defined_ = residuals_.evaluate(start);
    const double slope = residuals_.jacobian().size() == 0 ? 0 : residuals_.jacobian().cwiseAbs().maxCoeff();
    if (is_defined_ && slope > 0) value_ = slope * length_;
  }

  bool is_defined() const { return is_defined_; }
  int unknowns() const { return static_cast<int>(point_.size()); }
  int equations() const { return static_cast<int>(residuals_.values().size()); }

  bool evaluate(const double* scaled) {
    point_ = in_units_of_user(scaled);
    return residuals_.evaluate(point_);
  }
  auto values() const { return residuals_.values() / value_; }
  auto jacobian() const { return residuals_.jacobian() * (length_ / value_); }
  /// Of the last evaluated point.
  const Residuals& of_user() const { return residuals_; }

  std::vector<double> scaled(std::vector<double> point) const {
    for (double& x : point) x /= length_;
    return point;
  }
  std::vector<double> in_units_of_user(const double* scaled) const {
    std::vector<double> result(scaled, scaled + point_.size());
    for (double& x : result) x *= length_;
    return result;
  }

 private:
  Residuals residuals_;
  std::vector<double> point_;
  double length_ = 0, value_ = 1;
  bool is_defined_ = false;
};

/// Ceres asks for values and derivatives in these two ways.
class SquaresCost final : public ceres::CostFunction {
 public:
  explicit SquaresCost(ScaledResiduals& residuals) : residuals_(residuals) {
    set_num_residuals(residuals.equations());
    mutable_parameter_block_sizes()->push_back(residuals.unknowns());
  }

  bool Evaluate(double const* const* parameters, double* values, double** jacobians) const override {
    if (!residuals_.evaluate(parameters[0])) return false;
    Eigen::Map<Eigen::VectorXd>(values, num_residuals()) = residuals_.values();
    if (jacobians == nullptr || jacobians[0] == nullptr) return true;
    Eigen::Map<Residuals::RowMajor>(jacobians[0], num_residuals(), residuals_.unknowns()) =
        residuals_.jacobian();
    return true;
  }

 private:
  ScaledResiduals& residuals_;
};

class SumOfSquares final : public ceres::FirstOrderFunction {
 public:
  explicit SumOfSquares(ScaledResiduals& residuals) : residuals_(residuals) {}

  bool Evaluate(const double* point, double* cost, double* gradient) const override {
    if (!residuals_.evaluate(point)) return false;
    *cost = residuals_.values().squaredNorm() / 2;
    if (gradient == nullptr) return true;
    Eigen::Map<Eigen::VectorXd>(gradient, residuals_.unknowns()) =
        residuals_.jacobian().transpose() * residuals_.values();
    return true;
  }
  int NumParameters() const override { return residuals_.unknowns(); }

 private:
  ScaledResiduals& residuals_;
};

/// Ends a search at its first root, or when somebody asks for it.
class EndAtRoot final : public ceres::IterationCallback {
 public:
  EndAtRoot(ScaledResiduals& residuals, const std::vector<double>& point, double tolerance,
            const std::stop_token& stop)
      : residuals_(residuals), point_(point), tolerance_(tolerance), stop_(stop) {}

  ceres::CallbackReturnType operator()(const ceres::IterationSummary&) override {
    if (stop_.stop_requested()) return ceres::SOLVER_ABORT;
    const bool is_root = residuals_.evaluate(point_.data()) && residuals_.of_user().relative() <= tolerance_;
    return is_root ? ceres::SOLVER_TERMINATE_SUCCESSFULLY : ceres::SOLVER_CONTINUE;
  }

 private:
  ScaledResiduals& residuals_;
  const std::vector<double>& point_;
  double tolerance_;
  const std::stop_token& stop_;
};

/// What both solvers of Ceres are told. Only rounding ends a search that finds no root.
template <class CeresOptions>
CeresOptions ceres_options(const LocalSearchOptions& options, EndAtRoot& end_at_root) {
  constexpr double kRounding = 1e-15;
  constexpr std::uint64_t kMost = std::numeric_limits<int>::max();
  CeresOptions result;
  result.max_num_iterations = static_cast<int>(std::min(options.maximum_iterations, kMost));
  result.function_tolerance = kRounding;
  result.parameter_tolerance = kRounding;
  result.gradient_tolerance = 0;
  result.logging_type = ceres::SILENT;
  result.update_state_every_iteration = true;
  result.callbacks.push_back(&end_at_root);
  return result;
}

struct CeresEnd {
  ceres::TerminationType type;
  std::size_t points;  ///< the start and one an iteration
};

CeresEnd run_levenberg_marquardt(ScaledResiduals& residuals, std::vector<double>& point,
                                 const LocalSearchOptions& options, EndAtRoot& end_at_root) {
  ceres::Problem problem;
  problem.AddResidualBlock(new SquaresCost(residuals), nullptr, point.data());  // the problem owns the cost
  auto settings = ceres_options<ceres::Solver::Options>(options, end_at_root);
  settings.linear_solver_type = ceres::DENSE_QR;
  settings.num_threads = 1;
  // Levenberg's damping, by the identity: coordinates have one unit, and Marquardt's, by the diagonal, lets
  // those run away that the equations hardly see.
  settings.jacobi_scaling = false;
  settings.min_lm_diagonal = settings.max_lm_diagonal = 1;
  ceres::Solver::Summary summary;
  ceres::Solve(settings, &problem, &summary);
  return {summary.termination_type, summary.iterations.size()};
}

CeresEnd run_bfgs(ScaledResiduals& residuals, std::vector<double>& point, const LocalSearchOptions& options,
                  EndAtRoot& end_at_root) {
  const ceres::GradientProblem problem(new SumOfSquares(residuals));  // owns
  auto settings = ceres_options<ceres::GradientProblemSolver::Options>(options, end_at_root);
  settings.line_search_direction_type = ceres::BFGS;
  ceres::GradientProblemSolver::Summary summary;
  ceres::Solve(settings, problem, point.data(), &summary);
  return {summary.termination_type, summary.iterations.size()};
}

LocalSearchEnd end_of(const Residuals& residuals, ceres::TerminationType type, double tolerance) {
  if (residuals.relative() <= tolerance) return LocalSearchEnd::root;
  if (type == ceres::USER_FAILURE) return LocalSearchEnd::stopped;
  if (residuals.is_stationary()) return LocalSearchEnd::stationary;
  return type == ceres::NO_CONVERGENCE ? LocalSearchEnd::budget : LocalSearchEnd::stalled;
}

}  // namespace

LocalSearch minimise_squares(const SystemFunctions& functions, std::vector<double> start, Minimiser minimiser,
                             const LocalSearchOptions& options, const std::stop_token& stop) {
  const NearestRounding nearest;
  FLAGS_minloglevel = google::GLOG_FATAL;  // what Ceres would log is told by the end
  ScaledResiduals residuals(functions, start);
  LocalSearch search;
  search.end = LocalSearchEnd::undefined;
  if (residuals.is_defined()) {
    std::vector<double> point = residuals.scaled(start);
    EndAtRoot end_at_root(residuals, point, options.tolerance, stop);
    const auto run = minimiser == Minimiser::bfgs ? run_bfgs : run_levenberg_marquardt;
    const CeresEnd ended = run(residuals, point, options, end_at_root);
    search.iterations = ended.points == 0 ? 0 : ended.points - 1;
    if (residuals.evaluate(point.data()))
      search.end = end_of(residuals.of_user(), ended.type, options.tolerance);
    start = residuals.in_units_of_user(point.data());
  }
  search.residual = residuals.of_user().largest();
  search.point = std::move(start);
  return search;
}

}  // namespace gcslab
