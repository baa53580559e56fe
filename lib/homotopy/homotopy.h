#pragma once

// H(x, t) = F(x, d(t)): the equations of a constraint system while their parameters d move.
//
// A point of the curve is v = (x / unit, t) in R^(m+1), where the unit is the size of the sketch, so that
// what follows the curve need not know whether lengths are in metres. Values and Jacobians are computed in
// doubles: equations of degree 2 and 3, as squared distances and volumes are, from lists of coefficients,
// others from tapes, one an equation, that see only the variables that occur in it.

#include <memory>
#include <span>
#include <vector>

#include "expression/tape_evaluator.h"
#include "geometry/geometric_equations.h"
#include "homotopy/cubic_forms.h"
#include "homotopy/figure_curve.h"
#include "homotopy/parameter_path.h"

namespace gcslab {

/// Of the factors of a curve's Jacobians.
enum class LinearAlgebra {
  automatic,  ///< dense below Homotopy::kSparseFrom unknowns, else sparse
  dense,
  sparse
};

/// What an equation, as balanced, equals at t: (1 - t) (start + leading t).
struct EquationOffset {
  std::size_t equation;
  double start, leading;
};

class Homotopy final : public FigureCurve {
 public:
  /// Where steps take the same time with both factors, by configs/study/path-cost.yaml: 100 to 150 unknowns
  /// of polygons and prisms, between 200 and 300 of triangulated polyhedra, whose factors fill in more.
  static constexpr std::size_t kSparseFrom = 160;

  /// The equations are as many as the unknowns. One thread uses it at a time.
  Homotopy(const GeometricEquations& equations, std::unique_ptr<ParameterPath> path, double unit = 1);
  Homotopy(const Homotopy&) = delete;
  Homotopy& operator=(const Homotopy&) = delete;

  std::size_t size() const override { return m_; }
  const ParameterPath& path() const { return *path_; }
  const std::vector<double>& weights() const { return weights_; }          ///< of the balanced equations
  const std::vector<EquationOffset>& offsets() const { return offsets_; }  ///< of the perturbed ones
  /// By what coordinate i of the curve is multiplied for unknown i.
  double unit(std::size_t i) const { return speed_[i]; }

  /// The point (x / unit, t) of the unknowns x, and back.
  std::vector<double> point(std::span<const double> unknowns, double t) const;
  std::vector<double> unknowns(std::span<const double> v) const override;

  /// Multiplies each equation by a number, so that the rows of the Jacobian at v have entries up to 1.
  void balance(std::span<const double> v);
  /// Lets an equation, as balanced, differ from 0: it becomes H_k - (1 - t) (H_k(start) + leading t), where
  /// `start` is a point with t = 0. So boolean constraints hold at t = 1 only, and where they hold at the
  /// start there, and critical points that they cause at other t are avoided (Imbach 2013, section 5.2).
  void perturb(std::size_t equation, std::span<const double> start, double leading);
  /// max |F| at v, of the equations as they were given; infinite where one is undefined.
  double residual(std::span<const double> v);

  bool values(std::span<const double> v, std::span<double> result) override;
  bool jacobian(std::span<const double> v, std::span<double> result, Matrix<double>& derivatives) override;
  void use(LinearAlgebra kind) { linear_algebra_ = kind; }
  const SparsityPattern* pattern() const override { return is_sparse() ? &pattern_ : nullptr; }

 private:
  /// An equation in the variables that occur in it.
  struct Equation {
    std::size_t row;
    std::unique_ptr<ExpressionGraph> graph;
    std::unique_ptr<Tape> tape;
    std::unique_ptr<TapeEvaluator<double>> evaluator;
    std::vector<std::size_t> variables;  ///< unknowns, then parameters, as the equations number them
    std::vector<double> point;
  };

  bool is_sparse() const {
    return linear_algebra_ == LinearAlgebra::sparse ||
           (linear_algebra_ == LinearAlgebra::automatic && m_ >= kSparseFrom);
  }
  void add(const Expression& equation, std::size_t row);
  void move_to(std::span<const double> v);
  bool evaluate(Equation& equation);

  std::size_t m_;
  std::unique_ptr<ParameterPath> path_;
  CubicForms forms_;
  std::vector<Equation> equations_;  ///< those that are not in `forms_`
  SparsityPattern pattern_;
  LinearAlgebra linear_algebra_ = LinearAlgebra::automatic;
  std::vector<EquationOffset> offsets_;
  std::vector<double> weights_;      ///< of the equations
  std::vector<double> x_;            ///< unknowns, then parameters
  std::vector<double> speed_;        ///< of x_ by the coordinate of the curve that moves it
  std::vector<std::size_t> column_;  ///< that coordinate
};

}  // namespace gcslab
