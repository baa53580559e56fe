#pragma once

// What a person sees while a search runs, and the watch over its memory.

#include <chrono>

#include "box_solver/search.h"
#include "experiments/commands/interruption.h"

namespace gcslab {

class SearchProgress final : public SearchObserver {
 public:
  /// Draws on standard error when that is a terminal. `memory_mb` <= 0: no limit.
  SearchProgress(bool is_terminal, double memory_mb, Interruption& interruption)
      : is_terminal_(is_terminal), memory_mb_(memory_mb), interruption_(&interruption) {}

  void batch_done(const SearchStatistics& statistics, std::size_t open, std::size_t solutions) override;
  /// Leaves the terminal with a clean line.
  void finish() const;

 private:
  using Clock = std::chrono::steady_clock;

  bool is_terminal_;
  double memory_mb_;
  Interruption* interruption_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point drawn_ = start_;
};

}  // namespace gcslab
