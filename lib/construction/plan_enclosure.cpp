#include "construction/plan_enclosure.h"

#include <algorithm>

#include "base/check.h"
#include "expression/tape_evaluator.h"

namespace gcslab {
namespace {

using Traits = NumberTraits<MpfrInterval>;

MpfrInterval number(double x) { return MpfrInterval(Interval(x)); }
bool is_negative(const MpfrInterval& x) { return !x.is_empty() && mpfr_sgn(x.upper()) < 0; }
bool is_positive(const MpfrInterval& x) { return !x.is_empty() && mpfr_sgn(x.lower()) > 0; }
bool is_known(const MpfrInterval& x) {
  return !x.is_empty() && mpfr_number_p(x.lower()) != 0 && mpfr_number_p(x.upper()) != 0;
}

/// n.Y + o = 0.
struct NumberPlane {
  std::vector<MpfrInterval> normal;
  MpfrInterval offset;
};

MpfrInterval dot(const std::vector<MpfrInterval>& a, const std::vector<MpfrInterval>& b) {
  MpfrInterval sum = number(0);
  for (std::size_t i = 0; i < a.size(); ++i) sum = sum + a[i] * b[i];
  return sum;
}

MpfrInterval determinant(const std::vector<NumberPlane>& planes) {
  const auto n = [&](std::size_t plane, std::size_t axis) -> const MpfrInterval& {
    return planes[plane].normal[axis];
  };
  const auto minor = [&](std::size_t i, std::size_t j) { return n(1, i) * n(2, j) - n(1, j) * n(2, i); };
  if (planes.size() == 1) return n(0, 0);
  if (planes.size() == 2) return n(0, 0) * n(1, 1) - n(0, 1) * n(1, 0);
  return n(0, 0) * minor(1, 2) + n(0, 1) * minor(2, 0) + n(0, 2) * minor(0, 1);
}

}  // namespace

/// Planes and sphere of a step, with numbers.
class PlanEnclosure::Loci {
 public:
  explicit Loci(const StepFormulas& step) : step_(&step), registers_(*step.loci.tape) {}

  void run(const std::vector<MpfrInterval>& x) {
    for (std::size_t i = 0; i < step_->loci.inputs.size(); ++i) registers_[i] = x[step_->loci.inputs[i]];
    registers_.run();
    planes_.clear();
    std::size_t next = 0;
    for (std::size_t k = 0; k < step_->planes; ++k) {
      NumberPlane& plane = planes_.emplace_back();
      for (std::size_t i = 0; i < step_->dimensions; ++i) plane.normal.push_back(output(next++));
      plane.offset = output(next++);
    }
  }

  bool has_sphere() const { return step_->form != StepForm::one_place; }
  const MpfrInterval& centre(std::size_t axis) const {
    return output(step_->planes * (step_->dimensions + 1) + axis);
  }
  const MpfrInterval& radius_squared() const { return output(step_->loci.tape->outputs().size() - 1); }
  bool meet_in_a_point() const {
    const MpfrInterval det = determinant(planes_);
    return is_positive(det) || is_negative(det);
  }

  /// Whether the sphere is empty or proved to miss a plane, or a combination of two, which holds the line in
  /// which they meet: |o| > r |n|. That does not need the planes to be in general position.
  bool are_apart() const {
    if (!has_sphere()) return false;
    if (is_negative(radius_squared())) return true;
    for (std::size_t k = 0; k < planes_.size(); ++k) {
      if (misses(planes_[k])) return true;
      for (std::size_t other = 0; other < planes_.size(); ++other) {
        if (other != k && misses(combined(planes_[k], planes_[other]))) return true;
      }
    }
    return false;
  }

 private:
  const MpfrInterval& output(std::size_t k) const { return registers_[step_->loci.tape->outputs()[k]]; }

  bool misses(const NumberPlane& plane) const {
    return is_negative(radius_squared() * dot(plane.normal, plane.normal) - sqr(plane.offset));
  }

  /// The plane with the part of its normal along the other's taken away, to a double.
  static NumberPlane combined(const NumberPlane& plane, const NumberPlane& other) {
    const Interval quotient = (dot(plane.normal, other.normal) / dot(other.normal, other.normal)).interval();
    const MpfrInterval factor = number(is_bounded(quotient) ? midpoint(quotient) : 0.0);
    NumberPlane result{{}, plane.offset - factor * other.offset};
    for (std::size_t i = 0; i < plane.normal.size(); ++i)
      result.normal.push_back(plane.normal[i] - factor * other.normal[i]);
    return result;
  }

  const StepFormulas* step_;
  TapeRegisters<MpfrInterval> registers_;
  std::vector<NumberPlane> planes_;
};

PlanEnclosure::PlanEnclosure(const PlanProgram& program, const std::vector<Expression>& parameters,
                             bool absorbs_elsewhere)
    : program_(&program), absorbs_elsewhere_(absorbs_elsewhere), run_(program) {
  GCSLAB_CHECK(program.plan().guides.empty());
  for (std::size_t p = 0; p < parameters.size(); ++p) {
    const Tape tape(parameters[p], 0);
    TapeEvaluator<MpfrInterval> evaluator(tape);
    evaluator.evaluate({});
    run_.variables()[program.parameter(p)] = evaluator.value();
  }
  for (std::size_t k = 1; k < program.steps().size(); ++k) loci_.emplace_back(program.steps()[k]);
}

PlanEnclosure::~PlanEnclosure() = default;

bool PlanEnclosure::each_figure(const std::function<bool(EnclosedFigure&&)>& use,
                                const std::stop_token& stop) {
  use_ = &use;
  stop_ = stop;
  empty_branches_ = 0;
  EnclosedFigure state{Branch(program_->plan().choices(), false), {}, PlanDoubt::none, 0};
  return descend(0, state);
}

bool PlanEnclosure::finish(const EnclosedFigure& state) {
  run_.compute_removed();
  for (std::size_t r = 0; r < program_->plan().removed.size(); ++r) {
    if (is_negative(run_.removed(r)) || is_positive(run_.removed(r))) {
      ++empty_branches_;
      return true;
    }
  }
  const std::size_t d = program_->dimension();
  EnclosedFigure found = state;
  for (std::size_t p = 0; p < program_->points(); ++p) {
    const auto first = run_.variables().begin() + static_cast<std::ptrdiff_t>(p * d);
    found.points.emplace_back(first, first + static_cast<std::ptrdiff_t>(d));
  }
  return (*use_)(std::move(found));
}

/// Whether everything of a prepared step with two places is known.
bool PlanEnclosure::is_regular(std::size_t k) const {
  const StepFormulas& step = program_->steps()[k];
  if (!is_known(run_.radicand(k))) return false;
  if (step.form != StepForm::two_places) return true;
  for (std::size_t i = 0; i < step.dimensions; ++i) {
    if (!is_known(run_.base(k, i)) || !is_known(run_.direction(k, i))) return false;
  }
  return true;
}

/// The rest of the tree below a state in which the steps before k are taken. False to stop.
bool PlanEnclosure::descend(std::size_t k, EnclosedFigure& state) {
  if (stop_.stop_requested()) return false;
  if (absorbs_elsewhere_ && state.doubt == PlanDoubt::frame) return (*use_)(EnclosedFigure(state));
  if (k == program_->steps().size()) return finish(state);
  const StepFormulas& step = program_->steps()[k];
  if (step.form == StepForm::origin) return descend(k + 1, state);
  Loci& loci = loci_[k - 1];
  loci.run(run_.variables());
  if (loci.are_apart()) {
    ++empty_branches_;
    return true;
  }
  run_.prepare(k);
  if (step.form == StepForm::one_place) {
    if (!loci.meet_in_a_point()) return place_in_ball(k, state);
    run_.place(k, number(0));
    return descend(k + 1, state);
  }
  if (!is_regular(k)) return place_in_ball(k, state);
  if (is_negative(run_.radicand(k))) {
    ++empty_branches_;
    return true;
  }
  return place_both(k, state);
}

bool PlanEnclosure::place_both(std::size_t k, EnclosedFigure& state) {
  const StepFormulas& step = program_->steps()[k];
  const bool is_in_frame = step.dimensions < program_->dimension();
  const MpfrInterval height = sqrt(run_.radicand(k));
  if (is_positive(run_.radicand(k))) {
    for (const bool is_below : {false, true}) {
      if (is_below && (is_in_frame || !step.choice)) continue;
      if (step.choice) state.branch[*step.choice] = is_below;
      // Deeper steps leave the formulas of this one as they are.
      run_.place(k, is_below ? -height : height);
      if (!descend(k + 1, state)) return false;
    }
    if (step.choice) state.branch[*step.choice] = false;
    return true;
  }
  EnclosedFigure doubtful = state;
  const PlanDoubt doubt = is_in_frame ? PlanDoubt::frame : PlanDoubt::touching;
  if (doubt > state.doubt) doubtful.doubt = doubt, doubtful.step = k;
  run_.place(k, is_in_frame || !step.choice
                    ? height
                    : MpfrInterval(MpfrNumber((-height).lower()), MpfrNumber(height.upper())));
  return descend(k + 1, doubtful);
}

/// Only the sphere is known, or nothing.
bool PlanEnclosure::place_in_ball(std::size_t k, EnclosedFigure& state) {
  const StepFormulas& step = program_->steps()[k];
  const Loci& loci = loci_[k - 1];
  EnclosedFigure doubtful = state;
  const PlanDoubt doubt = step.dimensions < program_->dimension() ? PlanDoubt::frame : PlanDoubt::many;
  if (doubt > state.doubt) doubtful.doubt = doubt, doubtful.step = k;
  for (std::size_t i = 0; i < step.dimensions; ++i) {
    MpfrInterval& x = run_.variables()[step.first + i];
    x = MpfrInterval(Interval::entire());
    if (!loci.has_sphere()) continue;
    x = loci.centre(i) + sqrt(loci.radius_squared()) * MpfrInterval(Interval(-1, 1));
  }
  return descend(k + 1, doubtful);
}

std::optional<EnclosedPoints> enclosed_figure(const PlanProgram& program, const PlanValues& values,
                                              const Branch& branch, int bits) {
  const Traits::Scope scope(bits);
  PlanRun<MpfrInterval> run(program);
  const auto copy = [&](const std::vector<double>& from, std::size_t first) {
    for (std::size_t i = 0; i < from.size(); ++i) run.variables()[first + i] = number(from[i]);
  };
  copy(values.parameters, program.parameter(0));
  copy(values.guides, program.guide(0));
  copy(values.offsets, program.offset(0));
  EnclosedPoints points;
  for (std::size_t k = 0; k < program.steps().size(); ++k) {
    const StepFormulas& step = program.steps()[k];
    if (step.form == StepForm::origin) continue;
    run.prepare(k);
    MpfrInterval height = number(0);
    if (step.form != StepForm::one_place) {
      if (!is_positive(run.radicand(k))) return std::nullopt;
      height = sqrt(run.radicand(k));
      if (step.choice && branch[*step.choice]) height = -height;
    }
    run.place(k, height);
    for (std::size_t i = 0; i < step.dimensions; ++i) {
      if (!is_known(run.variables()[step.first + i])) return std::nullopt;
    }
  }
  for (std::size_t p = 0; p < program.points(); ++p) {
    const auto first = run.variables().begin() + static_cast<std::ptrdiff_t>(p * program.dimension());
    points.emplace_back(first, first + static_cast<std::ptrdiff_t>(program.dimension()));
  }
  return points;
}

}  // namespace gcslab
