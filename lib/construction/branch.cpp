#include "construction/branch.h"

#include <algorithm>
#include <cmath>

#include "geometry/numeric_vector.h"
#include "geometry/sketch.h"

namespace gcslab {

std::string text_of(const Branch& branch) {
  std::string text;
  for (const bool is_negative : branch) text += is_negative ? '-' : '+';
  return text;
}

PlanEvaluator::PlanEvaluator(const PlanProgram& program) : program_(&program), run_(program) {}

void PlanEvaluator::set(const PlanValues& values) {
  std::vector<double>& x = run_.variables();
  std::ranges::fill(x, 0.0);
  double size = 0;
  const auto copy = [&](const std::vector<double>& from, std::size_t first) {
    for (std::size_t i = 0; i < from.size(); ++i) x[first + i] = from[i];
  };
  copy(values.parameters, program_->parameter(0));
  copy(values.guides, program_->guide(0));
  copy(values.offsets, program_->offset(0));
  for (const double value : values.parameters) size = std::max(size, std::abs(value));
  for (const double value : values.guides) size = std::max(size, std::abs(value));
  constexpr double kRounding = 1e-14;
  rounding_ = kRounding * size * size;
}

PlanFailure PlanEvaluator::prepare(std::size_t step) {
  const StepFormulas& formulas = program_->steps()[step];
  if (formulas.form == StepForm::origin) return PlanFailure::none;
  run_.prepare(step);
  if (formulas.form == StepForm::one_place) {
    run_.place(step, 0);
    for (std::size_t i = 0; i < formulas.dimensions; ++i) {
      if (!std::isfinite(run_.variables()[formulas.first + i])) return PlanFailure::many;
    }
    return PlanFailure::none;
  }
  const double radicand = run_.radicand(step);
  if (!std::isfinite(radicand)) return PlanFailure::many;
  if (radicand < -rounding_) return PlanFailure::no_intersection;
  if (formulas.form == StepForm::on_axis) run_.place(step, 0);
  return PlanFailure::none;
}

Figure PlanEvaluator::figure() const {
  const std::size_t d = program_->dimension();
  Figure result;
  for (std::size_t p = 0; p < program_->points(); ++p) {
    const auto first = run_.variables().begin() + static_cast<std::ptrdiff_t>(p * d);
    result.emplace_back(first, first + static_cast<std::ptrdiff_t>(d));
  }
  return result;
}

PlanPlace PlanEvaluator::evaluate(const PlanValues& values, const Branch& branch) {
  set(values);
  for (std::size_t k = 0; k < program_->steps().size(); ++k) {
    const PlanFailure failure = prepare(k);
    if (failure != PlanFailure::none) return {failure, k, {}};
    const StepFormulas& step = program_->steps()[k];
    if (step.form != StepForm::two_places) continue;
    const double height = std::sqrt(std::max(run_.radicand(k), 0.0));
    run_.place(k, branch[*step.choice] ? -height : height);
  }
  return {PlanFailure::none, 0, figure()};
}

void PlanEvaluator::each_branch(const PlanValues& values, bool up_to_reflection,
                                const std::function<void(const Branch&, const Figure&)>& use) {
  set(values);
  Branch branch(program_->plan().choices(), false);
  descend(0, up_to_reflection, true, branch, use);
}

/// `is_flat`: the points so far are in the plane (on the line) of the frame.
void PlanEvaluator::descend(std::size_t k, bool up_to_reflection, bool is_flat, Branch& branch,
                            const std::function<void(const Branch&, const Figure&)>& use) {
  if (k == program_->steps().size()) {
    use(branch, figure());
    return;
  }
  if (prepare(k) != PlanFailure::none) return;
  const StepFormulas& step = program_->steps()[k];
  const std::size_t normal = program_->dimension() - 1;
  if (step.form != StepForm::two_places) {
    const bool is_out = step.dimensions > normal && run_.variables()[step.first + normal] != 0;
    descend(k + 1, up_to_reflection, is_flat && !is_out, branch, use);
    return;
  }
  const double height = std::sqrt(std::max(run_.radicand(k), 0.0));
  run_.place(k, height);
  const double up = run_.variables()[step.first + normal];
  run_.place(k, -height);
  const double down = run_.variables()[step.first + normal];
  const bool is_in_frame = step.dimensions < program_->dimension();
  // The plane of the frame is a mirror of everything before, and the two places are mirror images.
  const bool is_mirrored = is_flat && up == -down && up != 0;
  const bool is_one = height == 0 || is_in_frame || (is_mirrored && up_to_reflection);
  const bool stays_flat = is_flat && up == 0 && down == 0;
  for (const bool is_negative : {false, true}) {
    if (is_negative && is_one) continue;
    branch[*step.choice] = is_negative;
    run_.place(k, is_negative ? -height : height);
    descend(k + 1, up_to_reflection, stays_flat, branch, use);
  }
  branch[*step.choice] = false;
}

PlanValues PlanEvaluator::read(const Figure& figure, const std::vector<double>& parameters) {
  PlanValues values{parameters, {}, {}, {}};
  for (const Guide& guide : program_->plan().guides) {
    const Numbers side = difference(figure[guide.point], figure[guide.centre]);
    values.guides.push_back(std::sqrt(dot(side, side)));
  }
  set(values);
  std::vector<double>& x = run_.variables();
  const std::vector<double> coordinates = coordinates_in_order(figure);
  std::ranges::copy(coordinates, x.begin());
  const Formulas& offsets = program_->offsets();
  TapeRegisters<double> registers(*offsets.tape);
  for (std::size_t i = 0; i < offsets.inputs.size(); ++i) registers[i] = x[offsets.inputs[i]];
  registers.run();
  for (std::size_t c = 0; c < program_->constraints(); ++c) {
    values.offsets.push_back(registers[offsets.tape->outputs()[c]]);
    x[program_->offset(c)] = values.offsets.back();
  }
  for (std::size_t k = 0; k < program_->steps().size(); ++k) {
    const StepFormulas& step = program_->steps()[k];
    if (step.form != StepForm::two_places) continue;
    run_.prepare(k);
    double height = 0;
    for (std::size_t i = 0; i < step.dimensions; ++i)
      height += (x[step.first + i] - run_.base(k, i)) * run_.direction(k, i);
    values.heights.push_back(height);
  }
  return values;
}

Branch PlanEvaluator::branch(const PlanValues& values) const {
  Branch result;
  for (const double height : values.heights) result.push_back(height < 0);
  return result;
}

Figure in_frame(const ConstraintSystem& system, const Plan& plan, const Figure& figure) {
  return in_frame(system, plan.frame(system.universe), figure);
}

}  // namespace gcslab
