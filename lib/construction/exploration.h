#pragma once

// New sketches from solutions, iterated: the parameters of a construction plan are read off each solution,
// the plan evaluated on all of its branches, and the path of each figure so found followed, until nothing new
// is found (Imbach 2013, section 4.2.3). What it finds is often everything; nothing says so.

#include <deque>

#include "construction/branch.h"
#include "homotopy/path_explanation.h"
#include "homotopy/sketch_homotopy.h"
#include "homotopy/sketch_solver.h"

namespace gcslab {

/// Of `explore`.
struct ExplorationOptions {
  PlanKind plan = PlanKind::henneberg;
  SketchHomotopyOptions homotopy{};
  TrackerOptions tracker{};
  std::string certifier = "krawczyk_slopes+kantorovich";
  std::uint64_t maximum_paths = 100'000;
  /// Branches to follow, as text_of writes them; empty: all.
  std::vector<std::string> branches{};
};

/// A sketch and where it comes from.
struct NewSketch {
  Figure figure;
  std::optional<std::size_t> solution;  ///< number of the class that it was made from; nothing: the user's
  Branch branch;
};

/// A path that was followed.
struct ExploredPath {
  NewSketch sketch;
  SketchSolutions found;
  PathExplanation explanation;
  std::vector<std::size_t> numbers;      ///< of its solutions, among those of all paths
  std::string escape{}, other_escape{};  ///< of ends at infinity: the configuration of the plan
  std::string refused{};                 ///< why the sketch could not be followed; empty where it was
};

struct Exploration {
  Plan plan;
  /// One of each class of figures up to isometry, in the order found.
  std::vector<SketchSolution> solutions;
  std::vector<ExploredPath> paths;
  std::size_t sketches = 0;  ///< that all branches gave, the user's included
  std::size_t repeated = 0;  ///< congruent to one that was followed
  std::size_t unread = 0;  ///< solutions with the points of the plan's frame on a line, which show no values
  bool is_finished = false;  ///< no sketch is left
};

/// `wanted` are the equations at t = 1, `values` the parameters there.
/// Throws NotApplicable as make_plan and SketchHomotopy for the user's sketch.
Exploration explore(const ConstraintSystem& system, const Frame& frame, const GeometricEquations& equations,
                    const std::vector<double>& values, const Figure& sketch, const SystemFunctions& wanted,
                    const ExplorationOptions& options, const std::stop_token& stop = {});

}  // namespace gcslab
