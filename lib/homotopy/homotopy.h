#pragma once

// H(x, t) = F(x, d(t)): the equations of a constraint system while their parameters d move.
//
// A point is v = (x, t) in R^(m+1). Values and Jacobians are computed in doubles from tapes, one an equation,
// that see only the variables that occur in it: an equation of a large figure is about few points.

#include <memory>
#include <span>
#include <vector>

#include "base/matrix.h"
#include "expression/tape_evaluator.h"
#include "geometry/geometric_equations.h"
#include "homotopy/parameter_path.h"

namespace gcslab {

class Homotopy {
 public:
  /// The equations are as many as the unknowns. One thread uses it at a time.
  Homotopy(const GeometricEquations& equations, std::unique_ptr<ParameterPath> path);
  Homotopy(const Homotopy&) = delete;
  Homotopy& operator=(const Homotopy&) = delete;

  /// m: the number of unknowns and equations.
  std::size_t size() const { return equations_.size(); }

  /// H(v), of length m. False where some equation is undefined.
  bool values(std::span<const double> v, std::span<double> result);
  /// H(v), and its m by m + 1 Jacobian, the derivative by t last. False where some equation is undefined.
  bool jacobian(std::span<const double> v, std::span<double> result, Matrix<double>& derivatives);

 private:
  /// An equation in the variables that occur in it.
  struct Equation {
    std::unique_ptr<ExpressionGraph> graph;
    std::unique_ptr<Tape> tape;
    std::unique_ptr<TapeEvaluator<double>> evaluator;
    std::vector<std::size_t> unknowns;    ///< its first variables
    std::vector<std::size_t> parameters;  ///< its other ones
    std::vector<double> point;
  };

  static Equation localised(const Expression& equation, std::size_t unknowns);
  bool evaluate(Equation& equation, std::span<const double> v);

  std::unique_ptr<ParameterPath> path_;
  std::vector<Equation> equations_;
  std::vector<double> parameters_, derivatives_;
};

}  // namespace gcslab
