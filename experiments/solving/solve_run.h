#pragma once

// One run of a solving method on a system: what `solve`, the task of the same name and tests share.

#include <cstdint>
#include <limits>
#include <optional>
#include <stop_token>
#include <string>

#include "box_solver/solver_method.h"
#include "experiments/corpus/problem.h"
#include "homotopy/path_tracker.h"

namespace gcslab {

struct SolveSettings {
  std::string method = "adaptive";
  Options options;
  int threads = 1;
  ProofLog* proof = nullptr;  ///< not for peers
  SearchRecord* record = nullptr;
  const GeometricSource* geometry = nullptr;                   ///< of a constraint system
  double memory_mb = std::numeric_limits<double>::infinity();  ///< of a peer's program
};

/// A path that was followed, with the number of the solution at each crossing.
struct FollowedPath {
  SketchPath path;
  std::vector<std::size_t> solution_of_crossing;
};

struct SolveOutcome {
  SearchResult search;
  Status status = Status::failed;
  std::string completeness = "none";  ///< or "proved"
  std::vector<FollowedPath> paths{};  ///< of methods that follow paths
  std::string reason{};               ///< of a peer that failed, was stopped or is not there
};

/// Searches the problem's box, or what `start` holds of it; a peer starts at the beginning.
SolveOutcome solve_system(const SystemFunctions& functions, const SolveSettings& settings,
                          const std::optional<SearchStart>& start, const std::stop_token& stop,
                          SearchObserver* observer = nullptr);

}  // namespace gcslab
