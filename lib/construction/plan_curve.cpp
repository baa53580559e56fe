#include "construction/plan_curve.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "geometry/figure_projection.h"
#include "geometry/sketch.h"

namespace gcslab {
PlanCurve::PlanCurve(const ConstraintSystem& system, const Frame& frame, const GeometricEquations& equations,
                     const PlanMotion& motion, const PlanValues& read, double t)
    : system_(&system),
      frame_(frame),
      equations_(&equations),
      motion_(&motion),
      program_(&motion.program()),
      m_(motion.guides() + program_->plan().choices()),
      weights_(m_, 1.0),
      run_(*program_),
      jets_(*program_),
      jet_values_(m_) {
  const std::size_t guides = motion.guides(), removed = program_->plan().removed.size();
  if (guides != removed)
    throw NotApplicable("the construction plan has " + std::to_string(guides) +
                        " guide parameters and removes " + std::to_string(removed) +
                        " constraints: the system is not well-constrained");
  start_ = point(read, t);
  std::vector<double> values(m_);
  Matrix<double> derivatives(m_, m_ + 1);
  if (!jacobian(start_, values, derivatives)) return;
  for (std::size_t k = 0; k < m_; ++k) {
    double largest = 0;
    for (const double d : derivatives.row(k)) largest = std::max(largest, std::abs(d));
    if (largest > 0) weights_[k] = 1 / largest;
  }
}

/// `seed` makes numbers with derivatives: of a value that moves with coordinate number `column` of the curve
/// at that speed.
template <class T, class Seed>
bool PlanCurve::carry_out(PlanRun<T>& run, std::span<const double> v, const Seed& seed,
                          std::span<T> result) const {
  const std::size_t guides = motion_->guides();
  const double unit = motion_->unit();
  motion_->set(run, v.first(guides), v[m_], m_, seed);
  const std::vector<StepFormulas>& steps = program_->steps();
  for (std::size_t k = 0; k < steps.size(); ++k) {
    if (steps[k].form == StepForm::origin) continue;
    run.prepare(k);
    T height = seed(0, m_, 0);
    if (steps[k].form == StepForm::on_axis && !(point_value(run.radicand(k)) > 0)) return false;
    if (steps[k].form == StepForm::two_places) {
      const std::size_t column = guides + *steps[k].choice;
      height = seed(unit * v[column], column, unit);
      result[*steps[k].choice] = sqr(height) - run.radicand(k);
      if (!std::isfinite(point_value(result[*steps[k].choice]))) return false;
    }
    run.place(k, height);
  }
  run.compute_removed();
  for (std::size_t r = 0; r < guides; ++r) {
    const T& value = result[program_->plan().choices() + r] = run.removed(r);
    if (!std::isfinite(point_value(value))) return false;
  }
  return true;
}

bool PlanCurve::values(std::span<const double> v, std::span<double> result) {
  const auto seed = [](double value, std::size_t, double) { return value; };
  if (!carry_out(run_, v, seed, result)) return false;
  for (std::size_t k = 0; k < m_; ++k) result[k] *= weights_[k];
  return true;
}

bool PlanCurve::jacobian(std::span<const double> v, std::span<double> result, Matrix<double>& derivatives) {
  for (std::size_t first = 0; first <= m_; first += kSlopes) {
    const auto seed = [first](double value, std::size_t column, double speed) {
      Jet<kSlopes> jet{value, {}};
      if (column >= first && column < first + kSlopes) jet.slopes[column - first] = speed;
      return jet;
    };
    if (!carry_out(jets_, v, seed, std::span(jet_values_))) return false;
    for (std::size_t k = 0; k < m_; ++k) {
      result[k] = weights_[k] * jet_values_[k].value;
      for (std::size_t j = first; j <= m_ && j < first + kSlopes; ++j)
        derivatives(k, j) = weights_[k] * jet_values_[k].slopes[j - first];
    }
  }
  return true;
}

std::vector<double> PlanCurve::point(const PlanValues& read, double t) const {
  std::vector<double> v;
  for (const double guide : read.guides) v.push_back(guide / motion_->unit());
  for (const double height : read.heights) v.push_back(height / motion_->unit());
  v.push_back(t);
  return v;
}

std::vector<double> PlanCurve::point(const Figure& figure, double t) const {
  const Figure there = in_frame(*system_, program_->plan(), figure);
  return point(PlanEvaluator(*program_).read(there, motion_->parameters(t)), t);
}

Figure PlanCurve::figure(std::span<const double> v) const {
  std::vector<double> unused(m_);
  const auto seed = [](double value, std::size_t, double) { return value; };
  carry_out(run_, v, seed, std::span(unused));
  const std::size_t d = program_->dimension();
  Figure result;
  for (std::size_t p = 0; p < program_->points(); ++p) {
    const auto first = run_.variables().begin() + static_cast<std::ptrdiff_t>(p * d);
    result.emplace_back(first, first + static_cast<std::ptrdiff_t>(d));
  }
  return result;
}

std::vector<double> PlanCurve::unknowns(std::span<const double> v) const {
  std::vector<double> result = unknowns_of(*equations_, in_frame_or_on_line(*system_, frame_, figure(v)));
  if (equations_->auxiliaries > 0)
    result = fit_auxiliaries(*system_, *equations_, std::move(result)).unknowns;
  return result;
}

}  // namespace gcslab
