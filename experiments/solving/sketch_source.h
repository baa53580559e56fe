#pragma once

// What the methods that start from a user's sketch share.

#include <vector>

#include "experiments/solving/solve_run.h"
#include "geometry/sketch.h"

namespace gcslab {

/// A constraint system that has a sketch.
struct SketchSource {
  const GeometricSource& geometry;
  Figure sketch;
};

/// Option `random_sketch`: the seed of a random sketch in place of the problem's own.
OptionSpec random_sketch_option();

/// The sketch that the options ask for. Throws NotApplicable, with what to do, where the problem is no
/// constraint system or has no sketch.
SketchSource sketch_source(const SolveSettings& settings);

/// A solution that a method in plain doubles found: with its certificate, or at the point with the claim
/// none.
Solution found_solution(const std::vector<double>& unknowns, std::optional<CertifiedRoot> root);

}  // namespace gcslab
