#pragma once

// One run of a solving method on a system: what `solve`, the task of the same name and tests share.

#include <cstdint>
#include <limits>
#include <optional>
#include <stop_token>
#include <string>

#include "box_solver/solver_method.h"
#include "experiments/corpus/problem.h"

namespace gcslab {

struct SolveSettings {
  std::string method = "adaptive";
  Options options;
  int threads = 1;
  ProofLog* proof = nullptr;  ///< not for peers
  SearchRecord* record = nullptr;
  double memory_mb = std::numeric_limits<double>::infinity();  ///< of a peer's program
};

struct SolveOutcome {
  SearchResult search;
  Status status = Status::failed;
  std::string completeness = "none";  ///< or "proved"
  std::string reason{};               ///< of a peer that failed, was stopped or is not there
};

/// Searches the problem's box, or what `start` holds of it; a peer starts at the beginning.
SolveOutcome solve_system(const SystemFunctions& functions, const SolveSettings& settings,
                          const std::optional<SearchStart>& start, const std::stop_token& stop,
                          SearchObserver* observer = nullptr);

}  // namespace gcslab
