#include "experiments/peers/peer.h"

#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <unistd.h>

namespace gcslab {

namespace fs = std::filesystem;

// Each is defined in a source file of its name.
#define GCSLAB_PEERS(X) \
  X(phcpack)            \
  X(ibex)

#define GCSLAB_DECLARE(name) Peer name##_peer();
GCSLAB_PEERS(GCSLAB_DECLARE)
#undef GCSLAB_DECLARE

const Registry<Peer>& peer_registry() {
#define GCSLAB_ENTRY(name) name##_peer(),
  static const Registry<Peer> registry("peer", {GCSLAB_PEERS(GCSLAB_ENTRY)});
#undef GCSLAB_ENTRY
  return registry;
}

std::string program_on_path(const std::string& name) {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "" : path);
  for (std::string folder; std::getline(folders, folder, ':');) {
    const fs::path file = fs::path(folder.empty() ? "." : folder) / name;
    std::error_code ignored;
    if (fs::is_regular_file(file, ignored) && access(file.c_str(), X_OK) == 0)
      return fs::absolute(file).string();
  }
  return "";
}

PeerAnswer solve_by_peer(const Peer& peer, const SystemFunctions& functions, const Options& options,
                         const Limits& limits, const std::stop_token& stop) {
  const std::string path = program_on_path(peer.program);
  if (path.empty()) {
    PeerAnswer answer;
    answer.status = Status::not_applicable;
    answer.reason = peer.name + " is not installed: no program '" + peer.program + "' on the PATH";
    return answer;
  }
  return peer.solve(functions, options, path, limits, stop);
}

}  // namespace gcslab
