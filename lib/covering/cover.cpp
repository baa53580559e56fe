#include "covering/cover.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"
#include "base/error.h"

namespace gcslab {
namespace {

class Subdivision {
 public:
  Subdivision(const SetBounds& set, const Box& domain, const CoverOptions& options,
              const std::stop_token& stop)
      : cover_{CoverTree(domain, options.depth, options.split), {}}, box_(domain), stop_(stop) {
    for (const auto& bound : set.equations) walks_.push_back(bound->walk(domain, options.depth));
    equations_ = walks_.size();
    for (const auto& bound : set.inequalities) walks_.push_back(bound->walk(domain, options.depth));
  }

  Cover run() {
    cell(0);
    return std::move(cover_);
  }

 private:
  void cell(int level) {
    if (stop_.stop_requested()) {
      cover_.tree.truncate();
      cover_.undecided.push_back(box_);
      return;
    }
    const bool may_meet = !excluded();
    cover_.tree.append(may_meet);
    if (!may_meet || level == cover_.tree.last_level()) return;
    if (cover_.tree.split() == Split::all) {
      halve(level, 0, box_.size());
    } else {
      const std::size_t variable = static_cast<std::size_t>(level) % box_.size();
      halve(level, variable, variable + 1);
    }
  }

  /// True only when the current box has no point of the set.
  bool excluded() {
    for (std::size_t i = 0; i < equations_; ++i) {
      if (walks_[i]->excludes_zero(box_)) return true;
    }
    for (std::size_t i = equations_; i < walks_.size(); ++i) {
      const Interval range = walks_[i]->bound(box_);
      if (is_empty(range) || range.lower > 0) return true;
    }
    return false;
  }

  /// Visits the children that arise from halving the variables first .. last - 1.
  void halve(int level, std::size_t first, std::size_t last) {
    if (first == last) {
      cell(level + 1);
      return;
    }
    const Interval side = box_[first];
    for (const Half half : {Half::lower, Half::upper}) {
      box_[first] = half == Half::lower ? lower_half(side) : upper_half(side);
      for (const auto& walk : walks_) walk->enter(first, half);
      halve(level, first + 1, last);
      for (const auto& walk : walks_) walk->leave();
    }
    box_[first] = side;
  }

  Cover cover_;
  Box box_;
  std::vector<std::unique_ptr<BoundWalk>> walks_;  ///< of the equations, then of the inequalities
  std::size_t equations_ = 0;
  const std::stop_token& stop_;
};

}  // namespace

Cover cover(const SetBounds& set, const Box& domain, const CoverOptions& options,
            const std::stop_token& stop) {
  GCSLAB_CHECK(!set.equations.empty() && options.depth >= 0);
  if (!std::ranges::all_of(domain, is_bounded)) {
    throw InputError("a cover needs a bounded box; give finite ends, for example with --box");
  }
  return Subdivision(set, domain, options, stop).run();
}

int depth_for_cell_size(const Box& domain, double cell_size) {
  if (!(cell_size > 0)) throw InputError("the cell size must be positive");
  double widest = 0;
  for (const Interval& side : domain) widest = std::max(widest, width(side));
  int depth = 0;
  while (std::ldexp(widest, -depth) > cell_size) ++depth;
  return depth;
}

}  // namespace gcslab
