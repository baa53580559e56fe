#pragma once

// What stops a running command early: Ctrl-C, a termination request, or its time limit.

#include <condition_variable>
#include <mutex>
#include <stop_token>
#include <thread>

#include "experiments/runner/interrupt.h"

namespace gcslab {

/// While alive, an interrupt requests a stop instead of ending the process, and so does the end of the time
/// limit.
class Interruption {
 public:
  /// `timeout_s` <= 0: no limit.
  explicit Interruption(double timeout_s);
  ~Interruption();
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;

  /// Requests the stop itself.
  void stop() { source_.request_stop(); }

  std::stop_token token() const { return source_.get_token(); }

 private:
  void watch(double timeout_s);

  InterruptGuard guard_;
  std::stop_source source_;
  std::mutex mutex_;
  std::condition_variable wake_;
  bool done_ = false;
  std::thread watcher_;
};

}  // namespace gcslab
