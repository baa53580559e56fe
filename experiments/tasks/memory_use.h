#pragma once

// Memory of this process.

#include <fstream>
#include <string>

namespace gcslab {

/// Largest resident memory since the program started, in MB of 10^6 bytes. (getrusage would count what the
/// process was before it became this program.)
inline double peak_rss_mb() {
  std::ifstream file("/proc/self/status");
  std::string word;
  while (file >> word) {
    double kilobytes = 0;
    if (word == "VmHWM:" && file >> kilobytes) return kilobytes * 1024 / 1e6;
  }
  return 0;
}

}  // namespace gcslab
