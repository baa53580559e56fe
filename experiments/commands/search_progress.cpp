#include "experiments/commands/search_progress.h"

#include <cstdio>
#include <fmt/format.h>

#include "experiments/runner/progress.h"
#include "experiments/tasks/memory_use.h"

namespace gcslab {

void SearchProgress::batch_done(const SearchStatistics& statistics, std::size_t open, std::size_t solutions) {
  const auto now = Clock::now();
  if (now - drawn_ < std::chrono::milliseconds(500)) return;
  drawn_ = now;
  if (memory_mb_ > 0 && peak_rss_mb() > memory_mb_) interruption_->stop();
  if (!is_terminal_) return;
  const double elapsed = std::chrono::duration<double>(now - start_).count();
  const double part = statistics.explored;
  const std::string left = part > 1e-6 ? duration_text(elapsed * (1 - part) / part) : "unknown";
  fmt::print(stderr, "\r\033[K{} boxes, {} open, {} solutions, {:.1f} % explored, {} left", statistics.boxes,
             open, solutions, 100 * part, left);
  std::fflush(stderr);
}

void SearchProgress::finish() const {
  if (is_terminal_ && drawn_ != start_) fmt::print(stderr, "\r\033[K");
}

}  // namespace gcslab
