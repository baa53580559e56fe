#pragma once

// The curve of a sketch's homotopy in the coordinates of several construction plans, each where its loci meet
// at good angles: a plan is singular where centres come on a line or planes become parallel, and the figures
// of a path with coplanar points come near to such places (the change of plan on the way: Imbach, Mathis,
// Schreck 2017).
//
// Plans are made when they are needed, from every frame (forward orders), and kept.

#include <memory>

#include "construction/plan_homotopy.h"
#include "homotopy/charted_curve.h"

namespace gcslab {

class PlanAtlas final : public ChartedCurve {
 public:
  /// The path of `sketched`, first by the plan of that kind. All that is given must outlive it. Throws
  /// NotApplicable as PlanHomotopy.
  PlanAtlas(const ConstraintSystem& system, const Frame& frame, const GeometricEquations& equations,
            const SketchHomotopy& sketched, PlanKind kind);

  std::size_t size() const override { return chart().curve().size(); }
  bool values(std::span<const double> v, std::span<double> result) override {
    return chart().curve().values(v, result);
  }
  bool jacobian(std::span<const double> v, std::span<double> result, Matrix<double>& derivatives) override {
    return chart().curve().jacobian(v, result, derivatives);
  }
  std::vector<double> unknowns(std::span<const double> v) const override {
    return charts_[current_]->curve().unknowns(v);
  }

  const std::vector<double>& begin() override;
  bool change_at(std::span<const double> v, bool is_stuck) override;
  std::vector<double> carried_over(std::span<const double> v) override;
  std::optional<std::vector<double>> start() override;
  /// A point of the homotopy of the constraint system itself.
  std::vector<double> chartless(std::span<const double> v) const override;

  const PlanHomotopy& first() const { return *charts_.front(); }
  std::size_t plans() const { return charts_.size(); }

 private:
  PlanHomotopy& chart() { return *charts_[current_]; }
  const PlanHomotopy& chart() const { return *charts_[current_]; }
  double quality(const PlanHomotopy& chart, const Figure& figure, double t) const;
  /// Adds a chart that is good at a figure, or the best of those that were tried, where one can be made.
  void add_chart(const Figure& figure, double t);

  const ConstraintSystem* system_;
  Frame frame_;
  const GeometricEquations* equations_;
  const SketchHomotopy* sketched_;
  PlanKind kind_;
  std::vector<std::vector<std::size_t>> orders_;
  Figure sketch_;
  std::vector<std::unique_ptr<PlanHomotopy>> charts_;
  std::size_t current_ = 0, last_ = 0;
  double searched_ = 1;  ///< the quality below which another chart is looked for again
};

}  // namespace gcslab
