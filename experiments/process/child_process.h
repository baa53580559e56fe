#pragma once

// A process of its own for something that may run wild: this program, started again with other arguments, or
// another one.
//
// The promise: it ends within some 20 ms of exceeding a limit, when this object goes, and when the process
// that started it dies, even by kill -9; it does not see the terminal's Ctrl-C. Only the thread that made the
// object may use it, and that thread must outlive it. Linux; resident memory and processor time are read from
// /proc and the CPU clock of the process, with the kernel's own limits (RLIMIT_CPU, RLIMIT_DATA) a little
// above as a second fence.

#include <chrono>
#include <string>
#include <sys/types.h>
#include <vector>

#include "experiments/process/limits.h"

namespace gcslab {

enum class StoppedBy { nothing, wall_limit, cpu_limit, memory_limit };

/// How a child ended and what was seen of it.
struct ChildEnd {
  StoppedBy stopped_by = StoppedBy::nothing;
  int exit_code = -1;       ///< -1 when a signal ended it
  int signal = 0;           ///< 0 when it ended by itself
  std::string stderr_tail;  ///< the last bytes that it wrote to stdout or stderr
  double wall_s = 0;
  double peak_rss_mb = 0;  ///< the most that was seen, every 10 ms
};

/// Another program.
struct ChildCommand {
  std::string program;  ///< path of the file
  std::vector<std::string> arguments;
  std::string folder;             ///< where it runs
  double maximum_file_mb = 1000;  ///< no file that it writes grows beyond this
};

class ChildProcess {
 public:
  /// Starts this program with `arguments`. Throws std::system_error when no process can be made.
  ChildProcess(const std::vector<std::string>& arguments, const Limits& limits);
  /// Starts another program.
  ChildProcess(const ChildCommand& command, const Limits& limits);
  /// Kills the child, with all processes of its group, if it still runs.
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// Looks at the child, kills it if it is over a limit, and says whether it has ended; to be called often.
  bool has_ended();
  /// Valid once it has ended.
  const ChildEnd& end() const { return end_; }
  /// Becomes readable when the child writes or ends; -1 when there is nothing more to read.
  int output_descriptor() const { return output_; }

 private:
  using Clock = std::chrono::steady_clock;

  void start(const std::vector<std::string>& words, const ChildCommand* other);
  void read_output();
  StoppedBy exceeded_limit();
  void kill_group() const;
  void reap();

  Limits limits_;
  Clock::time_point start_ = Clock::now();
  pid_t process_ = -1;
  int output_ = -1;
  bool reaped_ = false;
  ChildEnd end_;
};

/// Waits until one of the children writes, ends or 10 ms have passed.
void wait_for_activity(const std::vector<const ChildProcess*>& children);

/// The last line of a text that is not blank; empty when there is none.
std::string last_line(const std::string& text);

}  // namespace gcslab
