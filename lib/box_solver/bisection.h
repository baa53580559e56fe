#pragma once

// Which side of a box to halve, and where.

#include <memory>
#include <string>
#include <vector>

#include "base/registry.h"
#include "certification/system_functions.h"
#include "interval/interval.h"

namespace gcslab {

/// Where a box is cut: side `variable` at `point`, which lies strictly between its ends.
struct Cut {
  std::size_t variable;
  double point;
};

/// What a bisection strategy may look at beside the box.
struct BisectionHistory {
  Box parent;                     ///< the box before contraction
  std::size_t last_variable = 0;  ///< cut last on the way to this box
};

/// A strategy belongs to one thread. It changes the cost of a search, never its truth.
class Bisection {
 public:
  virtual ~Bisection() = default;
  /// One of the variables whose sides are in `open`, which is not empty.
  virtual std::size_t choose(const Box& box, const std::vector<std::size_t>& open,
                             const BisectionHistory& history) = 0;
};

/// A strategy that gives each variable a score and cuts the side with the largest.
class ScoredBisection : public Bisection {
 public:
  /// The widest side where the scores say nothing.
  std::size_t choose(const Box& box, const std::vector<std::size_t>& open,
                     const BisectionHistory& history) final;
  /// One score a variable, none of them negative; all 0 where nothing is known.
  virtual const std::vector<double>& scores(const Box& box) = 0;
};

struct BisectionVariant {
  std::string name;
  std::string summary;
  std::unique_ptr<Bisection> (*make)(const SystemFunctions&);
};

const Registry<BisectionVariant>& bisection_registry();

/// The strategy relative_smear_sum.
std::unique_ptr<ScoredBisection> make_relative_smear_sum(const SystemFunctions& functions);

/// The point near the middle at which a side is cut; for an unbounded side a point that leaves the parts of
/// comparable orders of magnitude. Nothing when no number lies strictly between its ends.
bool cut_point(const Interval& side, double& point);

}  // namespace gcslab
