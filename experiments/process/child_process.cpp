#include "experiments/process/child_process.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <ctime>
#include <fcntl.h>
#include <fstream>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define GCSLAB_SANITIZED 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer) || __has_feature(memory_sanitizer)
#define GCSLAB_SANITIZED 1
#endif
#endif

namespace gcslab {
namespace {

constexpr double kBytesPerMb = 1e6;
constexpr std::size_t kTailBytes = 4096;
constexpr int kPollMilliseconds = 10;

[[noreturn]] void fail_system(const char* what) {
  throw std::system_error(errno, std::generic_category(), what);
}

// ---- between fork and exec: async-signal-safe calls only
// -------------------------------------------------------------

void limit_resource(int resource, double amount) {
  constexpr double kNoLimit = 9e18;
  if (!(amount < kNoLimit)) return;
  rlimit limit{};
  limit.rlim_cur = static_cast<rlim_t>(amount);
  limit.rlim_max = limit.rlim_cur + 1;
  setrlimit(static_cast<__rlimit_resource_t>(resource), &limit);
}

void set_kernel_limits(const Limits& limits) {
  const rlimit no_core{0, 0};
  setrlimit(RLIMIT_CORE, &no_core);
  limit_resource(RLIMIT_CPU, std::ceil(limits.cpu_s) + 1);
#ifndef GCSLAB_SANITIZED  // sanitizers reserve terabytes
  constexpr double kCodeAndStacks = 64e6;
  limit_resource(RLIMIT_DATA, limits.memory_mb * kBytesPerMb + kCodeAndStacks);
#endif
}

/// `other` is the program to become; null: this one again.
[[noreturn]] void become_child(char* const* arguments, const ChildCommand* other, const Limits& limits,
                               pid_t parent, int output) {
  constexpr int kCannotExecute = 127;
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(kCannotExecute);  // the parent died before it could be watched
  set_kernel_limits(limits);
  const int nothing = open("/dev/null", O_RDONLY);
  dup2(nothing, STDIN_FILENO);
  dup2(output, STDOUT_FILENO);
  dup2(output, STDERR_FILENO);
  if (other != nullptr) {
    limit_resource(RLIMIT_FSIZE, other->maximum_file_mb * kBytesPerMb);
    if (chdir(other->folder.c_str()) != 0) _exit(kCannotExecute);
  }
  execv(other != nullptr ? other->program.c_str() : "/proc/self/exe", arguments);
  constexpr char kMessage[] = "cannot execute the program\n";
  static_cast<void>(!write(STDERR_FILENO, kMessage, sizeof kMessage - 1));
  _exit(kCannotExecute);
}

// ---- what /proc and the clocks say
// -----------------------------------------------------------------------------------

double resident_mb(pid_t process) {
  std::ifstream file("/proc/" + std::to_string(process) + "/statm");
  double pages_in_all = 0;
  double pages_resident = 0;
  file >> pages_in_all >> pages_resident;
  return pages_resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / kBytesPerMb;
}

double cpu_seconds(pid_t process) {
  clockid_t clock{};
  timespec time{};
  if (clock_getcpuclockid(process, &clock) != 0 || clock_gettime(clock, &time) != 0) return 0;
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

}  // namespace

ChildProcess::ChildProcess(const std::vector<std::string>& arguments, const Limits& limits)
    : limits_(limits) {
  std::vector<std::string> words = {"gcslab"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  start(words, nullptr);
}

ChildProcess::ChildProcess(const ChildCommand& command, const Limits& limits) : limits_(limits) {
  std::vector<std::string> words = {command.program};
  words.insert(words.end(), command.arguments.begin(), command.arguments.end());
  start(words, &command);
}

void ChildProcess::start(const std::vector<std::string>& words, const ChildCommand* other) {
  std::vector<std::string> texts = words;
  std::vector<char*> pointers;
  pointers.reserve(texts.size() + 1);
  for (std::string& text : texts) pointers.push_back(text.data());
  pointers.push_back(nullptr);
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) fail_system("cannot make a pipe");
  const pid_t parent = getpid();
  process_ = fork();
  if (process_ == 0) become_child(pointers.data(), other, limits_, parent, ends[1]);
  close(ends[1]);
  output_ = ends[0];
  if (process_ < 0) {
    close(output_);
    fail_system("cannot start a process");
  }
  setpgid(process_, process_);  // here too: whoever comes first
  fcntl(output_, F_SETFL, O_NONBLOCK);
}

ChildProcess::~ChildProcess() {
  if (!reaped_) {
    kill_group();
    reap();
  }
  if (output_ >= 0) close(output_);
}

bool ChildProcess::has_ended() {
  if (reaped_) return true;
  read_output();
  siginfo_t state{};
  const int looked = waitid(P_PID, static_cast<id_t>(process_), &state, WEXITED | WNOHANG | WNOWAIT);
  const bool ended = looked == 0 && state.si_pid == process_;
  if (!ended) {
    end_.stopped_by = exceeded_limit();
    if (end_.stopped_by == StoppedBy::nothing) return false;
  }
  kill_group();  // before it is reaped, while the group's number is surely its own
  reap();
  read_output();
  return true;
}

void ChildProcess::read_output() {
  constexpr int kMostReads = 16;  // a full pipe; a child that never stops writing must not keep us here
  char buffer[kTailBytes];
  for (int i = 0; i < kMostReads && output_ >= 0; ++i) {
    const ssize_t count = read(output_, buffer, sizeof buffer);
    if (count < 0) return;  // nothing now
    if (count == 0) {
      close(output_);
      output_ = -1;
      return;
    }
    end_.stderr_tail.append(buffer, static_cast<std::size_t>(count));
    if (end_.stderr_tail.size() > kTailBytes) end_.stderr_tail.erase(0, end_.stderr_tail.size() - kTailBytes);
  }
}

StoppedBy ChildProcess::exceeded_limit() {
  end_.peak_rss_mb = std::max(end_.peak_rss_mb, resident_mb(process_));
  if (end_.peak_rss_mb > limits_.memory_mb) return StoppedBy::memory_limit;
  if (std::chrono::duration<double>(Clock::now() - start_).count() > limits_.wall_s)
    return StoppedBy::wall_limit;
  if (cpu_seconds(process_) > limits_.cpu_s) return StoppedBy::cpu_limit;
  return StoppedBy::nothing;
}

void ChildProcess::kill_group() const {
  kill(-process_, SIGKILL);
  kill(process_, SIGKILL);
}

void ChildProcess::reap() {
  int status = 0;
  while (waitpid(process_, &status, 0) < 0 && errno == EINTR) {
  }
  end_.wall_s = std::chrono::duration<double>(Clock::now() - start_).count();
  if (WIFEXITED(status)) end_.exit_code = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) end_.signal = WTERMSIG(status);
  reaped_ = true;
}

void wait_for_activity(const std::vector<const ChildProcess*>& children) {
  std::vector<pollfd> watched;
  watched.reserve(children.size());
  for (const ChildProcess* child : children) watched.push_back({child->output_descriptor(), POLLIN, 0});
  poll(watched.data(), watched.size(), kPollMilliseconds);
}

std::string last_line(const std::string& text) {
  const std::size_t end = text.find_last_not_of(" \t\r\n");
  if (end == std::string::npos) return "";
  const std::size_t start = text.find_last_of('\n', end);
  return text.substr(start + 1, end - start);
}

}  // namespace gcslab
