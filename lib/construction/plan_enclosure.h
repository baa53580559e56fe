#pragma once

// All figures of a plan, enclosed: its evaluation on every branch over outward-rounded intervals of any
// precision.
//
// Promise: every figure that the plan constructs from the values, in the plan's frame, lies in one of the
// enclosures. A branch is left out where a radicand is negative, where a locus is proved to miss another, or
// where a removed constraint is proved to be violated. What the precision does not decide is followed as one
// branch with a doubt: two places that may be one, and loci that may meet in infinitely many points, of which
// only the sphere that they lie on is known. So an enclosure without a doubt contains one figure of the plan.

#include <functional>
#include <optional>
#include <stop_token>
#include <string>

#include "construction/branch.h"
#include "interval/mpfr_interval.h"

namespace gcslab {

/// Coordinates of all points.
using EnclosedPoints = std::vector<std::vector<MpfrInterval>>;

/// What keeps a branch from being decided.
enum class PlanDoubt {
  none,
  touching,  ///< loci touch, or nearly: two places are one, or there is none
  many,      ///< loci may meet in infinitely many points: centres at one place or on a line, planes parallel
  frame      ///< the points of the plan's frame may be on a line (at one place): it does not hold the figure
};

struct EnclosedFigure {
  Branch branch;
  EnclosedPoints points;
  PlanDoubt doubt = PlanDoubt::none;
  std::size_t step = 0;  ///< the first of the gravest doubt
};

class PlanEnclosure {
 public:
  /// `parameters` are constant expressions. The program, which has no guides, must outlive it. A
  /// NumberTraits<MpfrInterval>::Scope must be alive from here to the last call. `absorbs_elsewhere`:
  /// constraints hold by another frame than the plan's, and so are about nothing where the plan's may not
  /// hold the figure: enclosures with that doubt have no points.
  PlanEnclosure(const PlanProgram& program, const std::vector<Expression>& parameters,
                bool absorbs_elsewhere = false);
  ~PlanEnclosure();

  /// Calls `use` for each enclosure, until it returns false or a stop is requested; then false.
  bool each_figure(const std::function<bool(EnclosedFigure&&)>& use, const std::stop_token& stop = {});
  /// Branches that were proved to have no figure, each counted where it ends.
  std::uint64_t empty_branches() const { return empty_branches_; }

 private:
  class Loci;

  bool descend(std::size_t step, EnclosedFigure& state);
  bool place_both(std::size_t step, EnclosedFigure& state);
  bool place_in_ball(std::size_t step, EnclosedFigure& state);
  bool finish(const EnclosedFigure& state);
  bool is_regular(std::size_t step) const;

  const PlanProgram* program_;
  bool absorbs_elsewhere_;
  PlanRun<MpfrInterval> run_;
  std::vector<Loci> loci_;
  const std::function<bool(EnclosedFigure&&)>* use_ = nullptr;
  std::stop_token stop_;
  std::uint64_t empty_branches_ = 0;
};

/// The coordinates of every point on one branch, from values taken as exact, with so many bits; nothing where
/// an instruction fails, or these bits do not tell.
std::optional<EnclosedPoints> enclosed_figure(const PlanProgram& program, const PlanValues& values,
                                              const Branch& branch, int bits);

}  // namespace gcslab
