#pragma once

// A path that was stopped, as a file: what `--pending` of a method that follows paths writes and `--resume`
// reads.

#include <filesystem>
#include <string>

#include "homotopy/path_tracker.h"

namespace gcslab {

/// What the path belongs to: the content of the problem, the method and its options.
struct PathIdentity {
  std::string problem_hash;
  std::string method;
  std::string options;
};

void write_path_state(const std::filesystem::path& file, const PathIdentity& identity,
                      const PathState& state);

/// Throws InputError when it is no such file, was changed, or belongs to another problem, method or options.
PathState read_path_state(const std::filesystem::path& file, const PathIdentity& identity);

}  // namespace gcslab
