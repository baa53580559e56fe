#include "experiments/commands/interruption.h"

#include <chrono>
namespace gcslab {

Interruption::Interruption(double timeout_s) : watcher_([this, timeout_s] { watch(timeout_s); }) {}

Interruption::~Interruption() {
  {
    const std::lock_guard lock(mutex_);
    done_ = true;
  }
  wake_.notify_one();
  watcher_.join();
}

void Interruption::watch(double timeout_s) {
  const auto start = std::chrono::steady_clock::now();
  std::unique_lock lock(mutex_);
  while (!wake_.wait_for(lock, std::chrono::milliseconds(20), [this] { return done_; })) {
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    if (InterruptGuard::interrupted() || (timeout_s > 0 && elapsed.count() > timeout_s))
      source_.request_stop();
  }
}

}  // namespace gcslab
