#pragma once

// Elapsed wall time and processor time, in seconds.

#include <chrono>
#include <ctime>

namespace gcslab {

/// Runs from its construction. CPU time is that of all threads of this process.
class Stopwatch {
 public:
  double wall_s() const { return std::chrono::duration<double>(Clock::now() - wall_start_).count(); }
  double cpu_s() const { return process_cpu_s() - cpu_start_; }

 private:
  using Clock = std::chrono::steady_clock;

  static double process_cpu_s() {
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  }

  Clock::time_point wall_start_ = Clock::now();
  double cpu_start_ = process_cpu_s();
};

}  // namespace gcslab
