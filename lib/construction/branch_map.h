#pragma once

// The removed constraints as a function of the guides and t, on one branch of a plan: F_b of Imbach 2013,
// section 4.3. It is defined where no radicand of the plan is negative.

#include "base/matrix.h"
#include "construction/branch.h"
#include "construction/plan_motion.h"
#include "interval/jet.h"

namespace gcslab {

class BranchMap {
 public:
  /// `motion` must outlive it. Throws NotApplicable for more guides than derivatives are carried, and unless
  /// the removed constraints are as many as the guides.
  explicit BranchMap(const PlanMotion& motion);

  std::size_t guides() const { return motion_->guides(); }
  std::size_t choices() const { return motion_->program().plan().choices(); }
  double unit() const { return motion_->unit(); }

  /// Whether F_b is defined; where it is not, the choice whose radicand is negative, or nothing where a step
  /// fails otherwise.
  struct Domain {
    bool is_inside = true;
    std::optional<std::size_t> border{};
  };
  /// `v` is (guides / unit, t); the result has a value a guide.
  Domain values(const Branch& branch, std::span<const double> v, std::span<double> result);
  /// The same with derivatives by v: guides times guides + 1. They are not finite on the border.
  Domain jacobian(const Branch& branch, std::span<const double> v, std::span<double> result,
                  Matrix<double>& derivatives);
  /// The heights of the last values that were defined.
  const std::vector<double>& heights() const { return heights_; }

 private:
  static constexpr std::size_t kSlopes = 8;

  template <class T, class Seed>
  Domain carry_out(PlanRun<T>& run, const Branch& branch, std::span<const double> v, const Seed& seed);

  const PlanMotion* motion_;
  PlanRun<double> run_;
  PlanRun<Jet<kSlopes>> jets_;
  std::vector<double> heights_;
};

}  // namespace gcslab
