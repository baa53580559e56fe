#pragma once

// The homotopy of a constraint system in the coordinates of a construction plan.
//
// A point of the curve is v = (guides / unit, heights / unit, t); the equations are h^2 = r for each choice
// of the plan and the removed constraints, on figures that satisfy all other constraints by construction.
// With the heights as unknowns the curve passes smoothly from one branch to another, where a height changes
// its sign: seen in the guides alone it meets the border of the domain of one branch there, and goes on in
// that of the other (Imbach 2013, section 4.3, which follows it with branches as functions). The figures are
// those of the homotopy of the constraint system itself, so that the path is the same, in 1 + guides +
// choices dimensions.

#include "construction/branch.h"
#include "construction/plan_motion.h"
#include "geometry/geometric_equations.h"
#include "homotopy/figure_curve.h"
#include "interval/jet.h"

namespace gcslab {

class PlanCurve final : public FigureCurve {
 public:
  /// `read` has the guides and heights of a figure of the curve at t, near which it is balanced. All that is
  /// given must outlive it. Throws NotApplicable unless the removed constraints are as many as the guides.
  PlanCurve(const ConstraintSystem& system, const Frame& frame, const GeometricEquations& equations,
            const PlanMotion& motion, const PlanValues& read, double t = 0);

  std::size_t size() const override { return m_; }
  bool values(std::span<const double> v, std::span<double> result) override;
  bool jacobian(std::span<const double> v, std::span<double> result, Matrix<double>& derivatives) override;
  std::vector<double> unknowns(std::span<const double> v) const override;

  /// The point of the values that it was made with.
  const std::vector<double>& start() const { return start_; }
  /// The point of a figure at t: what the plan needs to construct it.
  std::vector<double> point(const Figure& figure, double t) const;
  /// The figure that the plan constructs, in its own frame.
  Figure figure(std::span<const double> v) const;

 private:
  /// So many derivatives at a time.
  static constexpr std::size_t kSlopes = 8;

  std::vector<double> point(const PlanValues& read, double t) const;
  template <class T, class Seed>
  bool carry_out(PlanRun<T>& run, std::span<const double> v, const Seed& seed, std::span<T> result) const;

  const ConstraintSystem* system_;
  Frame frame_;
  const GeometricEquations* equations_;
  const PlanMotion* motion_;
  const PlanProgram* program_;
  std::size_t m_;
  std::vector<double> weights_;  ///< of the equations
  std::vector<double> start_;
  mutable PlanRun<double> run_;
  PlanRun<Jet<kSlopes>> jets_;
  std::vector<Jet<kSlopes>> jet_values_;
};

}  // namespace gcslab
