#pragma once

// What a person sees while a path is followed, and the file from which it can be followed on.

#include <chrono>
#include <optional>
#include <string>

#include "experiments/commands/interruption.h"
#include "experiments/solving/path_state_json.h"

namespace gcslab {

class PathSession {
 public:
  /// Draws on standard error when that is a terminal; stops when more than `memory_mb` (> 0) are used. Every
  /// ten seconds the path so far goes to the file `pending`, unless that is empty.
  PathSession(PathIdentity identity, std::string pending, bool is_terminal, double memory_mb,
              Interruption& interruption)
      : identity_(std::move(identity)),
        pending_(std::move(pending)),
        is_terminal_(is_terminal),
        memory_mb_(memory_mb),
        interruption_(&interruption) {}

  void stepped(const PathState& state);
  /// Leaves the terminal with a clean line, and the file with what is left: nothing when the path has ended.
  void finish(bool has_ended);

 private:
  using Clock = std::chrono::steady_clock;

  PathIdentity identity_;
  std::string pending_;
  bool is_terminal_;
  double memory_mb_;
  Interruption* interruption_;
  std::optional<PathState> last_;  ///< kept only when it is to be written
  Clock::time_point start_ = Clock::now();
  Clock::time_point drawn_ = start_, written_ = start_;
  bool was_drawn_ = false;
};

}  // namespace gcslab
