#pragma once

// The points of a path, for drawings: noted while it is followed, and then as many as wanted, with points of
// the cubics between steps where the steps are fewer.

#include "homotopy/path_tracker.h"

namespace gcslab {

class PathTrace {
 public:
  /// Notes each step. The trace must outlive it. A path that is followed again from its start replaces what
  /// was noted.
  PathObserver observer();

  /// The path ends at this point, which lies within its last step: the start of a cycle, or a crossing at
  /// which the path is left.
  void end_at(const std::vector<double>& v);

  struct Samples {
    std::vector<std::vector<double>> points;
    std::size_t start = 0;  ///< number of the point at which the path begins
  };
  /// At most `most` points (at least 2), from the end of the other direction, if it was followed, over the
  /// start to the end of the first. None where no step succeeded.
  Samples samples(std::size_t most) const;

 private:
  using Steps = std::vector<CurvePoint>;

  std::size_t steps() const;

  Steps forward_, backward_;  ///< each from the start
};

}  // namespace gcslab
