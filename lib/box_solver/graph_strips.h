#pragma once

// Strips lower <= t - slope x <= upper around the graph of a function t = phi(x) over an interval: together a
// polygon around it (Tahari 2011, section 5, figure 5.4, for exp). The slopes are those at both ends and that
// of the chord; where phi is convex or concave, the strips meet in its chord and its tangents at the ends.
//
// Promise: (x, phi(x)) is in each strip for every x of the interval at which phi is defined.

#include <array>
#include <memory>

#include "expression/tape_evaluator.h"
#include "interval/fast_interval.h"

namespace gcslab {

struct Strip {
  double slope = 0;
  Interval range = Interval::entire();  ///< of t - slope x
};

inline constexpr std::size_t kStripsOfGraph = 3;
using StripsOfGraph = std::array<Strip, kStripsOfGraph>;

class GraphStrips {
 public:
  /// `step` is an operation on one operand; only its kind and its exponent count. A
  /// NumberTraits<FastInterval> scope must be alive from here to the last call.
  explicit GraphStrips(Expression step);

  /// The strips over a bounded interval.
  const StripsOfGraph& around(const Interval& x);

 private:
  static constexpr std::size_t kPieces = 16;
  /// phi over a set, with its slopes, which are entire where phi has none.
  struct Values {
    FastInterval x, values, slopes = FastInterval(Interval::entire());
  };

  Values over(const Interval& x);
  /// Encloses t - slope x over the piece with that number.
  FastInterval range_on(std::size_t piece, double slope) const;
  Strip strip(double slope) const;

  std::unique_ptr<ExpressionGraph> graph_;
  std::unique_ptr<Tape> tape_;
  TapeEvaluator<FastInterval> evaluator_;
  std::array<Values, kPieces> pieces_;
  std::array<Values, kPieces + 1> ends_;  ///< of the pieces
  StripsOfGraph strips_;
};

}  // namespace gcslab
