#include "experiments/commands/path_session.h"

#include <cstdio>
#include <filesystem>
#include <fmt/format.h>

#include "experiments/runner/progress.h"
#include "experiments/tasks/memory_use.h"

namespace gcslab {

void PathSession::stepped(const PathState& state) {
  constexpr std::uint64_t kLookEvery = 64;  // steps; a look at the clock is not free
  if (!pending_.empty() && (interruption_->token().stop_requested() || state.path.steps % kLookEvery == 0))
    last_ = state;
  if (state.path.steps % kLookEvery != 0) return;
  const auto now = Clock::now();
  if (!pending_.empty() && now - written_ > std::chrono::seconds(10)) {
    write_path_state(pending_, identity_, state);
    written_ = now;
  }
  if (now - drawn_ < std::chrono::milliseconds(500)) return;
  drawn_ = now;
  if (memory_mb_ > 0 && peak_rss_mb() > memory_mb_) interruption_->stop();
  if (!is_terminal_) return;
  was_drawn_ = true;
  const double elapsed = std::chrono::duration<double>(now - start_).count();
  fmt::print(
      stderr,
      "\r\033[K{} steps, length {:.4g}, {} crossings of t = 1, {} so far; a path's end is not foreseen",
      state.path.steps, state.path.length, state.path.crossings.size(), duration_text(elapsed));
  std::fflush(stderr);
}

void PathSession::finish(bool has_ended) {
  if (was_drawn_) fmt::print(stderr, "\r\033[K");
  if (pending_.empty()) return;
  if (has_ended || !last_) {
    std::filesystem::remove(pending_);
    fmt::print(stderr, "gcslab: the path has {}; {} is not written\n", has_ended ? "ended" : "not begun",
               pending_);
  } else {
    write_path_state(pending_, identity_, *last_);
  }
}

}  // namespace gcslab
