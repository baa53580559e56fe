#pragma once

// What the methods that follow paths share: their options, and what becomes of a path.

#include <chrono>
#include <optional>

#include "experiments/solving/solve_method.h"
#include "homotopy/path_trace.h"
#include "homotopy/path_tracker.h"
#include "homotopy/sketch_homotopy.h"

namespace gcslab {

/// In what the trackers of methods differ.
struct TrackerDefaults {
  std::string predictor = "hermite";
  std::string corrector = "chord";
  std::string step_control = "adaptive";
  double first_step = 0.01;
  double tolerance = 1e-6;
};

std::vector<OptionSpec> homotopy_option_specs();
std::vector<OptionSpec> tracker_option_specs(const TrackerDefaults& defaults = {});
/// Names of theorems.
OptionSpec certifier_option();

SketchHomotopyOptions homotopy_options(const Options& options);
/// `extent`: how large figures on the way are, in sizes of the sketch.
TrackerOptions tracker_options(const Options& options, double extent);

/// How long the steps of a path take. Moments are noted after each.
class StepClock {
 public:
  /// Tells `next`, where there is one, of each step too.
  PathObserver observer(PathObserver next);
  /// Nothing before the second step.
  std::optional<double> median_s();

 private:
  std::chrono::steady_clock::time_point last_;
  std::vector<double> seconds_;
};

/// Notes the path while it is followed, where a trace is asked for.
class Tracer {
 public:
  /// All must outlive it.
  Tracer(const SolveSettings& settings, const FigureCurve& curve, const GeometricEquations& equations)
      : settings_(&settings), curve_(&curve), equations_(&equations) {}

  PathObserver observer();
  /// `start` is where the path starts. Nothing unless a trace is asked for.
  std::optional<TracedPath> traced(const Path& path, const std::vector<double>& start,
                                   bool is_to_first_crossing);

 private:
  const SolveSettings* settings_;
  const FigureCurve* curve_;
  const GeometricEquations* equations_;
  PathTrace trace_;
};

/// Of a path that was given up in some direction.
bool is_given_up(const Path& path);

/// The outcome of one path: its solutions, partial unless it was given up; to have stopped at the first
/// crossing may be what was asked for.
SolveOutcome outcome_of(FollowedPath followed, bool is_to_first_crossing);

}  // namespace gcslab
