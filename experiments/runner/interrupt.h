#pragma once

// Ctrl-C and kill, noticed without ending the program; full disks, noticed as errors of a write.

#include <array>
#include <csignal>

namespace gcslab {

/// While one lives, SIGINT, SIGTERM and SIGHUP only set a flag (where they were not ignored already), and
/// SIGXFSZ is ignored so that a write beyond RLIMIT_FSIZE fails with an error instead of killing the process.
class InterruptGuard {
 public:
  InterruptGuard();
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;

  /// Whether one of the signals has come since the first guard was made.
  static bool interrupted();

 private:
  static constexpr std::array<int, 3> kSignals = {SIGINT, SIGTERM, SIGHUP};

  std::array<struct sigaction, 3> before_{};
  struct sigaction file_size_before_ {};
};

}  // namespace gcslab
