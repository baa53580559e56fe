#include "experiments/runner/run_folder.h"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include "base/atomic_file.h"
#include "base/error.h"

namespace gcslab {
namespace {

namespace fs = std::filesystem;

int take_lock(const fs::path& file) {
  const int descriptor = open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
  if (descriptor < 0) throw InputError("cannot write " + file.string() + ": " + std::strerror(errno));
  if (flock(descriptor, LOCK_EX | LOCK_NB) == 0) return descriptor;
  const int cause = errno;
  close(descriptor);
  if (cause != EWOULDBLOCK) throw InputError("cannot lock " + file.string() + ": " + std::strerror(cause));
  throw InputError("another run writes to " + file.parent_path().string() +
                   "; wait for its end or choose another folder with --out");
}

/// Drafts of rows that a killed run did not finish.
void remove_drafts(const fs::path& jobs) {
  std::error_code ignored;
  for (const fs::directory_entry& entry : fs::directory_iterator(jobs, ignored)) {
    if (entry.path().filename().string().find(".draft-") != std::string::npos)
      fs::remove(entry.path(), ignored);
  }
}

}  // namespace

RunFolder::RunFolder(fs::path folder) : folder_(std::move(folder)) {
  make_folder(folder_ / "jobs");
  lock_ = take_lock(folder_ / "lock");
  remove_drafts(folder_ / "jobs");
  std::error_code ignored;
  fs::remove_all(exchange(), ignored);
  make_folder(exchange());
}

RunFolder::~RunFolder() {
  std::error_code ignored;
  fs::remove_all(exchange(), ignored);
  close(lock_);  // the file stays: removing it would let two runs hold two locks
}

}  // namespace gcslab
