#include "construction/branch_map.h"

#include <cmath>

#include "base/error.h"

namespace gcslab {

BranchMap::BranchMap(const PlanMotion& motion)
    : motion_(&motion), run_(motion.program()), jets_(motion.program()), heights_(choices()) {
  const std::size_t removed = motion.program().plan().removed.size();
  if (guides() != removed)
    throw NotApplicable("the construction plan has " + std::to_string(guides()) +
                        " guide parameters and removes " + std::to_string(removed) +
                        " constraints: the system is not well-constrained");
  if (guides() + 1 > kSlopes)
    throw NotApplicable("the construction plan has " + std::to_string(guides()) +
                        " guide parameters, more than " + std::to_string(kSlopes - 1));
}

template <class T, class Seed>
BranchMap::Domain BranchMap::carry_out(PlanRun<T>& run, const Branch& branch, std::span<const double> v,
                                       const Seed& seed) {
  motion_->set(run, v.first(guides()), v[guides()], guides(), seed);
  const std::vector<StepFormulas>& steps = motion_->program().steps();
  for (std::size_t k = 0; k < steps.size(); ++k) {
    if (steps[k].form == StepForm::origin) continue;
    run.prepare(k);
    T height = seed(0, 0, 0);
    if (steps[k].form != StepForm::one_place) {
      const double radicand = point_value(run.radicand(k));
      if (!(radicand >= 0)) return {false, radicand < 0 ? steps[k].choice : std::nullopt};
      if (!std::isfinite(radicand)) return {false, std::nullopt};
      if (steps[k].choice) {
        const T root = sqrt(run.radicand(k));
        height = branch[*steps[k].choice] ? -root : root;
        heights_[*steps[k].choice] = point_value(height);
      }
    }
    run.place(k, height);
  }
  run.compute_removed();
  return {};
}

BranchMap::Domain BranchMap::values(const Branch& branch, std::span<const double> v,
                                    std::span<double> result) {
  const Domain domain = carry_out(run_, branch, v, [](double value, std::size_t, double) { return value; });
  if (!domain.is_inside) return domain;
  for (std::size_t r = 0; r < guides(); ++r) {
    result[r] = run_.removed(r);
    if (!std::isfinite(result[r])) return {false, std::nullopt};
  }
  return domain;
}

BranchMap::Domain BranchMap::jacobian(const Branch& branch, std::span<const double> v,
                                      std::span<double> result, Matrix<double>& derivatives) {
  const auto seed = [](double value, std::size_t column, double speed) {
    Jet<kSlopes> jet{value, {}};
    jet.slopes[column] = speed;
    return jet;
  };
  const Domain domain = carry_out(jets_, branch, v, seed);
  if (!domain.is_inside) return domain;
  for (std::size_t r = 0; r < guides(); ++r) {
    result[r] = jets_.removed(r).value;
    for (std::size_t j = 0; j <= guides(); ++j) derivatives(r, j) = jets_.removed(r).slopes[j];
  }
  return domain;
}

}  // namespace gcslab
