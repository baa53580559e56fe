#pragma once

// One run of a peer's program in a folder of its own, which goes when it is over.

#include <filesystem>
#include <stop_token>
#include <string>
#include <vector>

#include "experiments/peers/peer.h"
#include "experiments/process/child_process.h"

namespace gcslab {

/// A new folder for temporary files; it goes with the object.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
  std::string text() const { return path_.string(); }

 private:
  std::filesystem::path path_;
};

/// What a peer wrote that is not as its format says.
class GarbledAnswer : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// How a program ended; `budget_exhausted` and `failed` with the reason, else `partial`.
PeerAnswer run_program(const ChildCommand& command, const Limits& limits, const std::stop_token& stop,
                       const Box& search_box);

/// The bytes of a file that the peer wrote. Throws GarbledAnswer when there is none or it is too large.
std::string peer_file(const std::filesystem::path& path);

/// `failed`, because of what the peer wrote.
PeerAnswer failed_answer(const std::string& reason);

}  // namespace gcslab
