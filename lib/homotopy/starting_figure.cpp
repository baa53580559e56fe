#include "homotopy/starting_figure.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <optional>

#include "expression/tape_evaluator.h"
#include "geometry/sketch.h"

namespace gcslab {
namespace {

/// The equations of the boolean constraints.
class BooleanEquations {
 public:
  BooleanEquations(const ConstraintSystem& system, const GeometricEquations& equations)
      : variables_(equations.unknowns.size() + equations.parameters.size()) {
    std::vector<Expression> chosen;
    for (std::size_t k = 0; k < equations.equations.size(); ++k) {
      const std::size_t constraint = equations.constraint_of_equation[k];
      if (system.constraints[constraint].kind->is_metric()) continue;
      chosen.push_back(equations.equations[k]);
      constraints_.push_back(constraint);
    }
    if (chosen.empty()) return;
    tape_.emplace(chosen, static_cast<int>(variables_));
    evaluator_.emplace(*tape_);
  }

  bool is_empty() const { return constraints_.empty(); }

  void evaluate(const std::vector<double>& unknowns) {
    std::vector<double> point = unknowns;
    point.resize(variables_, 0.0);
    evaluator_->evaluate(point);
    const auto rows = static_cast<Eigen::Index>(constraints_.size());
    const auto columns = static_cast<Eigen::Index>(unknowns.size());
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
  std::size_t worst_constraint() const {
    Eigen::Index worst = 0;
    values_.cwiseAbs().maxCoeff(&worst);
    return constraints_[static_cast<std::size_t>(worst)];
  }

 private:
  std::size_t variables_;
  std::vector<std::size_t> constraints_;
  std::optional<Tape> tape_;
  std::optional<TapeEvaluator<double>> evaluator_;
  Eigen::VectorXd values_;
  Eigen::MatrixXd jacobian_;
};

/// The change of the unknowns from `first` on that brings the linearised equations nearest to 0, the smallest
/// one of these.
void step(BooleanEquations& booleans, std::vector<double>& unknowns, std::size_t first) {
  booleans.evaluate(unknowns);
  const auto columns = static_cast<Eigen::Index>(unknowns.size() - first);
  const Eigen::VectorXd change =
      booleans.jacobian().rightCols(columns).completeOrthogonalDecomposition().solve(booleans.values());
  for (Eigen::Index i = 0; i < columns; ++i) unknowns[first + static_cast<std::size_t>(i)] -= change[i];
}

}  // namespace

StartingFigure starting_figure(const ConstraintSystem& system, const Frame& frame,
                               const GeometricEquations& equations, const Figure& sketch) {
  constexpr int kIterations = 50;
  constexpr double kExact = 1e-13;
  StartingFigure start{unknowns_of(equations, in_frame(system, frame, sketch)), {}};
  BooleanEquations booleans(system, equations);
  if (!booleans.is_empty()) {
    if (equations.auxiliaries > 0)
      step(booleans, start.unknowns, start.unknowns.size() - equations.auxiliaries);
    double size = 1;
    for (const double x : start.unknowns) size = std::max(size, std::abs(x));
    for (int k = 0; k < kIterations; ++k) {
      step(booleans, start.unknowns, 0);
      if (booleans.values().cwiseAbs().maxCoeff() <= kExact * size) break;
    }
    booleans.evaluate(start.unknowns);
    if (!(booleans.values().cwiseAbs().maxCoeff() <= 1e3 * kExact * size))
      throw NotApplicable("no figure near the sketch satisfies " +
                          system.describe(system.constraints[booleans.worst_constraint()]) +
                          "; draw it nearer to that");
  }
  start.parameters = parameters_of(system, figure_at(equations, start.unknowns));
  return start;
}

}  // namespace gcslab
