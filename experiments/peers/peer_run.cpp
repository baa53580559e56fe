#include "experiments/peers/peer_run.h"

#include <cerrno>
#include <cstdlib>
#include <fmt/format.h>
#include <fstream>
#include <sstream>
#include <system_error>

namespace gcslab {

namespace fs = std::filesystem;

namespace {

PeerAnswer stopped_answer(const std::string& reason, const Box& search_box) {
  PeerAnswer answer;
  answer.status = Status::budget_exhausted;
  answer.reason = reason;
  answer.found.pending = {search_box};
  return answer;
}

std::string end_text(const ChildEnd& end) {
  const std::string said = last_line(end.stderr_tail);
  const std::string how = end.signal != 0 ? fmt::format("was ended by signal {}", end.signal)
                                          : fmt::format("ended with exit code {}", end.exit_code);
  return how + (said.empty() ? "" : "; its last line: " + said);
}

}  // namespace

TemporaryFolder::TemporaryFolder() {
  std::string name = (fs::temp_directory_path() / "gcslab-peer-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr)
    throw std::system_error(errno, std::generic_category(), "cannot make the folder " + name);
  path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

PeerAnswer run_program(const ChildCommand& command, const Limits& limits, const std::stop_token& stop,
                       const Box& search_box) {
  ChildProcess child(command, limits);
  while (!child.has_ended()) {
    if (stop.stop_requested()) return stopped_answer("the program was stopped", search_box);
    wait_for_activity({&child});
  }
  const ChildEnd& end = child.end();
  if (end.stopped_by == StoppedBy::memory_limit)
    return stopped_answer(fmt::format("memory limit of {:g} MB", limits.memory_mb), search_box);
  if (end.stopped_by != StoppedBy::nothing) return stopped_answer("time limit", search_box);
  PeerAnswer answer;
  answer.status = end.exit_code == 0 ? Status::partial : Status::failed;
  if (answer.status == Status::failed) answer.reason = command.program + " " + end_text(end);
  return answer;
}

std::string peer_file(const fs::path& path) {
  constexpr std::uintmax_t kMaximumBytes = 500'000'000;
  std::error_code missing;
  const std::uintmax_t size = fs::is_regular_file(path, missing) ? fs::file_size(path, missing) : 0;
  if (missing || size == 0) throw GarbledAnswer("it wrote no " + path.filename().string());
  if (size > kMaximumBytes)
    throw GarbledAnswer(fmt::format("its {} has {} bytes", path.filename().string(), size));
  std::ifstream stream(path, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

PeerAnswer failed_answer(const std::string& reason) {
  PeerAnswer answer;
  answer.reason = reason;
  return answer;
}

}  // namespace gcslab
