#pragma once

// What a person sees while an experiment runs: on a terminal one line that is rewritten, with the time left;
// elsewhere a line for each job that ends.

#include <chrono>
#include <cstddef>
#include <iosfwd>
#include <string>

namespace gcslab {

struct FinishedJob;

class Progress {
 public:
  /// `to_run` jobs will end.
  Progress(std::ostream& stream, bool is_terminal, std::string experiment, std::size_t to_run);
  /// Leaves the terminal with a clean line.
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void finished(const FinishedJob& job);
  /// Redraws the line of a terminal at most twice a second.
  void tick(std::size_t running);

 private:
  using Clock = std::chrono::steady_clock;

  std::string time_left() const;
  void clear_line();

  std::ostream& stream_;
  bool is_terminal_;
  std::string experiment_;
  std::size_t to_run_;
  std::size_t done_ = 0;
  Clock::time_point start_ = Clock::now();
  Clock::time_point drawn_{};
};

/// "3 s", "4 min 05 s", "2 h 07 min".
std::string duration_text(double seconds);

}  // namespace gcslab
