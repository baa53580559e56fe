#pragma once

// One run of a solving method on a system: what `solve`, the task of the same name and tests share.

#include <cstdint>
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
  ProofLog* proof = nullptr;
  SearchRecord* record = nullptr;
};

struct SolveOutcome {
  SearchResult search;
  Status status = Status::failed;
  std::string completeness;  ///< "proved" or "none"
};

/// Searches the problem's box, or what `start` holds of it.
SolveOutcome solve_system(const SystemFunctions& functions, const SolveSettings& settings,
                          const std::optional<SearchStart>& start, const std::stop_token& stop,
                          SearchObserver* observer = nullptr);

}  // namespace gcslab
