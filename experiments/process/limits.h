#pragma once

#include <limits>

namespace gcslab {

/// What one job may use. Wall and CPU time are for one repetition; a job that has to be stopped by force is
/// stopped a little later than `repetitions` times that.
struct Limits {
  double wall_s = 60.0;
  double cpu_s = std::numeric_limits<double>::infinity();  ///< of all threads together; infinite: not limited
  double memory_mb = 2000.0;                               ///< resident memory, 1 MB = 10^6 bytes

  bool operator==(const Limits&) const = default;
};

}  // namespace gcslab
