#include "base/atomic_file.h"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <sstream>
#include <unistd.h>

#include "base/error.h"

namespace gcslab {
namespace {

namespace fs = std::filesystem;

InputError cannot_write(const fs::path& path, int error) {
  return InputError("cannot write " + path.string() + ": " + std::strerror(error) +
                    " (choose another place or free some space)");
}

/// A file descriptor that closes itself.
class Descriptor {
 public:
  Descriptor(const fs::path& path, int flags) : fd_(::open(path.c_str(), flags, 0644)) {}
  ~Descriptor() {
    if (fd_ >= 0) ::close(fd_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  bool is_open() const { return fd_ >= 0; }

  /// False, with errno set, when some byte could not be written.
  bool write_all(std::string_view text) const {
    while (!text.empty()) {
      const ssize_t written = ::write(fd_, text.data(), text.size());
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) return false;
      text.remove_prefix(static_cast<std::size_t>(written));
    }
    return true;
  }
  /// Devices and pipes cannot be synchronised; that is no fault.
  bool flush() const { return ::fsync(fd_) == 0 || errno == EINVAL || errno == EROFS; }

 private:
  int fd_;
};

void write_in_place(const fs::path& path, std::string_view text, int flags) {
  const Descriptor file(path, flags);
  if (!file.is_open() || !file.write_all(text) || !file.flush()) throw cannot_write(path, errno);
}

}  // namespace

std::string read_file(const fs::path& path) {
  if (fs::is_directory(path)) throw InputError(path.string() + ": is a folder; a file was expected");
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw InputError("cannot read " + path.string() + ": " + std::strerror(errno));
  std::ostringstream text;
  text << stream.rdbuf();
  return std::move(text).str();
}

void write_file_atomically(const fs::path& path, std::string_view text) {
  std::error_code ignored;
  if (fs::exists(path, ignored) && !fs::is_regular_file(path, ignored)) {
    write_in_place(path, text, O_WRONLY);
    return;
  }
  const fs::path draft = path.string() + ".draft-" + std::to_string(::getpid());
  try {
    write_in_place(draft, text, O_WRONLY | O_CREAT | O_TRUNC);
  } catch (const InputError&) {
    const int cause = errno;
    fs::remove(draft, ignored);
    throw cannot_write(path, cause);
  }
  std::error_code error;
  fs::rename(draft, path, error);
  if (error) {
    fs::remove(draft, ignored);
    throw cannot_write(path, error.value());
  }
}

void check_writable(const fs::path& path) {
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) throw cannot_write(path, EISDIR);
  const bool exists = fs::exists(path, ignored);
  const fs::path folder = path.has_parent_path() ? path.parent_path() : ".";
  const fs::path& asked = exists && !fs::is_regular_file(path, ignored) ? path : folder;
  if (::access(asked.c_str(), W_OK) != 0) throw cannot_write(path, errno);
  if (&asked == &folder && !fs::is_directory(folder, ignored)) throw cannot_write(path, ENOTDIR);
}

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw InputError("cannot make folder " + folder.string() + ": " + error.message());
}

}  // namespace gcslab
