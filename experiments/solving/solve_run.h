#pragma once

// One run of a solving method on a system: what `solve`, the task of the same name and tests share.

#include <cstdint>
#include <limits>
#include <optional>
#include <stop_token>
#include <string>

#include "box_solver/solver_method.h"
#include "experiments/corpus/problem.h"
#include "experiments/solving/plan_diagram.h"
#include "experiments/solving/traced_path.h"
#include "homotopy/path_explanation.h"
#include "homotopy/sketch_solver.h"

namespace gcslab {

struct SolveSettings {
  std::string method = "adaptive";
  Options options;
  int threads = 1;
  ProofLog* proof = nullptr;  ///< not for peers
  SearchRecord* record = nullptr;
  const GeometricSource* geometry = nullptr;   ///< of a constraint system
  std::optional<std::uint64_t> sketch_seed{};  ///< draws a random sketch, where no option does
  std::size_t traced_points = 0;               ///< of paths, at most; 0: no trace is kept
  PathObserver path_observer{};                ///< of methods that follow paths: told each step
  const PathState* path_from = nullptr;        ///< the same: to go on from there
  double memory_mb = std::numeric_limits<double>::infinity();  ///< of a peer's program
};

struct FollowedPath {
  SketchSolutions found;
  PathExplanation explanation;
  std::vector<std::size_t> numbers{};  ///< of its solutions among those of the outcome
  std::optional<TracedPath> trace{};
  std::optional<double> step_s{};        ///< median time of its steps
  std::string escape{}, other_escape{};  ///< configurations of a plan that ends at infinity meet
  /// What is special about the plan where the path ends otherwise, and about each crossing, empty or not.
  std::string plan_event{}, other_plan_event{};
  std::vector<std::string> crossing_events{};
  std::string origin{};  ///< of the sketch, where it is not the user's: "class 2, branch +-+"
};

/// What is told of a construction plan.
struct PlanReport {
  std::vector<std::string> lines;  ///< as a text: steps, guides, removed constraints
  std::size_t guides = 0, choices = 0, removed = 0;
  PlanDiagram diagram{};
  std::optional<std::uint64_t> branches{};        ///< that may have a figure, of an evaluation on all
  std::optional<std::uint64_t> empty_branches{};  ///< that were proved to have none
  std::optional<std::size_t> sketches{};          ///< that its branches gave
  std::optional<std::size_t> unread{};            ///< solutions that show no values, their frame on a line
  std::optional<std::uint64_t> branch_changes{};  ///< on the path
  std::optional<std::size_t> plans{};             ///< that were made, where the path goes through several
  std::optional<std::uint64_t> plan_changes{};    ///< on the path
  std::optional<double> simplices_per_edge{};     ///< of a path as long as an edge along an axis
  struct NewFigure {
    std::string origin;  ///< "branch +-+"
    Figure figure;       ///< in the frame of the plan
  };
  std::vector<NewFigure> new_sketches{};  ///< that the first solution gave
  struct Escape {
    std::string object;
    std::vector<std::string> guides;
    std::string configuration;
  };
  /// Points that can go to infinity, of methods whose paths can.
  std::optional<std::vector<Escape>> escapes{};
};

struct SolveOutcome {
  SearchResult search;
  Status status = Status::failed;
  std::string completeness = "none";  ///< or "proved"
  std::vector<FollowedPath> paths{};  ///< of methods that follow paths
  /// Of a peer that failed, was stopped or is not there; of a local search, why it found nothing.
  std::string reason{};
  std::optional<std::uint64_t> steps{};  ///< of all paths, or iterations of a local search
  std::optional<PlanReport> plan{};      ///< of methods that construct
};

/// Searches the problem's box, or what `start` holds of it; a peer starts at the beginning.
SolveOutcome solve_system(const SystemFunctions& functions, const SolveSettings& settings,
                          const std::optional<SearchStart>& start, const std::stop_token& stop,
                          SearchObserver* observer = nullptr);

}  // namespace gcslab
