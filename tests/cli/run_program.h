#pragma once

// Starts the selftest program of the runner as a user or a script would, and looks at what it leaves behind.

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <functional>
#include <gtest/gtest.h>
#include <map>
#include <string>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <vector>

#include "base/atomic_file.h"
#include "experiments/runner/job_row.h"

namespace gcslab {

namespace fs = std::filesystem;

inline void pause_ms(int milliseconds) {
  std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
}

/// Asks every 5 ms until `condition` holds; false when it does not within 10 s.
inline bool eventually(const std::function<bool()>& condition) {
  constexpr int kTries = 2000;
  for (int i = 0; i < kTries; ++i) {
    if (condition()) return true;
    pause_ms(5);
  }
  return false;
}

struct Ended {
  int exit_code = -1;  ///< -1 after a signal
  std::string out;
  std::string err;
};

/// A process of the program that runs beside the test.
class RunningProgram {
 public:
  /// `before` is called in the new process, to lower limits or privileges.
  RunningProgram(const fs::path& folder, std::vector<std::string> arguments,
                 const std::function<void()>& before = {})
      : out_(folder / "stdout"), err_(folder / "stderr") {
    arguments.insert(arguments.begin(), GCSLAB_SELFTEST_PROGRAM);
    std::vector<char*> pointers;
    for (std::string& argument : arguments) pointers.push_back(argument.data());
    pointers.push_back(nullptr);
    process_ = fork();
    if (process_ != 0) return;
    dup2(open(out_.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644), STDOUT_FILENO);
    dup2(open(err_.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644), STDERR_FILENO);
    setenv("ASAN_OPTIONS", "handle_segv=0", 1);  // crashes are to be crashes, with sanitizers too
    if (before) before();
    execv(pointers[0], pointers.data());
    _exit(126);
  }
  ~RunningProgram() {
    if (process_ > 0) {
      send(SIGKILL);
      wait();
    }
  }
  RunningProgram(const RunningProgram&) = delete;
  RunningProgram& operator=(const RunningProgram&) = delete;

  void send(int signal) const { kill(process_, signal); }

  Ended wait() {
    int status = 0;
    waitpid(process_, &status, 0);
    process_ = -1;
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_file(out_), read_file(err_)};
  }

 private:
  fs::path out_;
  fs::path err_;
  pid_t process_ = -1;
};

/// A test with a folder of its own, which is empty at first and goes with the test.
class RunTest : public testing::Test {
 protected:
  RunTest() {
    std::string name = (fs::temp_directory_path() / "gcslab-run-XXXXXX").string();
    folder_ = mkdtemp(name.data());
    fs::permissions(folder_, fs::perms::all);
  }
  ~RunTest() override { fs::remove_all(folder_); }

  /// Writes a config of experiment "e" with task and experiment filled in; its path.
  std::string config(const std::string& rest) const {
    const fs::path file = folder_ / "config.yaml";
    write_file_atomically(file, "experiment: e\ntask: selftest\n" + rest);
    return file.string();
  }

  fs::path runs() const { return folder_ / "runs"; }
  fs::path jobs() const { return runs() / "e/jobs"; }

  std::vector<std::string> run_arguments(const std::string& config_file,
                                         std::vector<std::string> more = {}) const {
    more.insert(more.begin(), {"run", config_file, "--out", runs().string()});
    return more;
  }

  Ended run(const std::string& config_file, const std::vector<std::string>& more = {},
            const std::function<void()>& before = {}) const {
    return RunningProgram(folder_, run_arguments(config_file, more), before).wait();
  }

  /// The text of every row by file name; a file that is no whole row fails the test.
  std::map<std::string, std::string> row_texts() const {
    std::map<std::string, std::string> texts;
    std::error_code none_yet;
    for (const fs::directory_entry& entry : fs::directory_iterator(jobs(), none_yet)) {
      if (entry.path().extension() != ".json") continue;
      texts[entry.path().filename()] = read_file(entry.path());
      EXPECT_NO_THROW(row_from_text(texts.rbegin()->second)) << entry.path();
    }
    return texts;
  }

  /// The rows by label.
  std::map<std::string, JobRow> rows_by_label() const {
    std::map<std::string, JobRow> rows;
    for (const auto& [file, text] : row_texts()) {
      JobRow row = row_from_text(text);
      rows[row.label] = row;
    }
    return rows;
  }

  /// How many processes have this test's folder on their command line.
  std::size_t processes_alive() const {
    std::size_t count = 0;
    for (const fs::directory_entry& entry : fs::directory_iterator("/proc")) {
      std::ifstream file(entry.path() / "cmdline");
      std::string line;
      std::getline(file, line);  // words end in zero bytes; empty when the process has just ended
      if (line.find(runs().string()) != std::string::npos) ++count;
    }
    return count;
  }

  fs::path folder_;
};

}  // namespace gcslab
