#pragma once

// Branches of a plan: its evaluation on one of them and on all, and the one that a figure is on.

#include <functional>
#include <string>

#include "construction/plan_run.h"

namespace gcslab {

/// For each choice of the plan, in its order, whether the height is negative.
using Branch = std::vector<bool>;
/// "+-+".
std::string text_of(const Branch& branch);

/// Why an instruction places no point.
enum class PlanFailure {
  none,
  no_intersection,  ///< the loci do not meet: a radicand is negative
  many,             ///< or nothing tells how: centres coincide or are on a line, planes are parallel
};

struct PlanPlace {
  PlanFailure failure = PlanFailure::none;
  std::size_t step = 0;  ///< the first that fails
  Figure figure;         ///< where none fails
};

/// Values of what a plan constructs from.
struct PlanValues {
  std::vector<double> parameters, guides, offsets;
  std::vector<double> heights;  ///< of each choice, where they are read off a figure
};

class PlanEvaluator {
 public:
  /// The program must outlive it.
  explicit PlanEvaluator(const PlanProgram& program);

  /// The figure on that branch. A radicand below 0 by no more than rounding is taken for 0.
  PlanPlace evaluate(const PlanValues& values, const Branch& branch);
  /// Calls `use` for the figures on all branches on which the plan is defined, each once: a choice between
  /// equal places is none. The height of the frame's last point in space is positive, which is a matter of
  /// where the figure is; with `up_to_reflection` that of the first point out of the frame's plane (line)
  /// too.
  void each_branch(const PlanValues& values, bool up_to_reflection,
                   const std::function<void(const Branch&, const Figure&)>& use);

  /// What the plan needs to construct a figure, in its own frame (figure_in_frame): on the branch of the
  /// heights it gives that figure again.
  PlanValues read(const Figure& figure, const std::vector<double>& parameters);
  Branch branch(const PlanValues& values) const;

 private:
  void set(const PlanValues& values);
  PlanFailure prepare(std::size_t step);
  void descend(std::size_t step, bool up_to_reflection, bool is_flat, Branch& branch,
               const std::function<void(const Branch&, const Figure&)>& use);
  Figure figure() const;

  const PlanProgram* program_;
  PlanRun<double> run_;
  double rounding_ = 0;
};

/// The figure moved to where the plan constructs. Throws InputError where the first points are on a line.
Figure in_frame(const ConstraintSystem& system, const Plan& plan, const Figure& figure);

}  // namespace gcslab
