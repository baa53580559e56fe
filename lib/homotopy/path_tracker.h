#pragma once

// The whole homotopy path of a sketch: a curve H(x, t) = 0 in R^(m+1), followed by prediction and correction.
//
// Prediction: the cubic through the last two points with their tangents (Hermite). Correction: Newton's chord
// method in the hyperplane across the last tangent, with the matrix factorised there, so that a step costs
// one Jacobian and one factorisation (Allgower, Georg 1990, chapters 6 and 10). The tangent keeps its
// orientation where t turns back. A step is refused, and halved, when the correction does not contract, goes
// far, or turns the tangent much: so it stays on its path unless another one is nearer than the step. Nothing
// here is proved; certification is another's work.
//
// A path that does not return to the sketch is followed in the other direction too.

#include <cstdint>
#include <stop_token>
#include <string_view>
#include <vector>

#include "homotopy/homotopy.h"

namespace gcslab {

struct TrackerOptions {
  double first_step = 0.01;
  double largest_step = 0.5;
  double least_step = 1e-10;
  double tolerance =
      1e-6;  ///< of the last correction of a point, relative to its size; crossings are polished
  double largest_turn = 0.4;  ///< of the tangent in a step, radians
  double deviation = 0.02;    ///< aimed at: of the prediction, as part of the step
  double infinity = 1e5;      ///< times the sketch's size: a path that gets there is said to go to infinity
  std::uint64_t maximum_steps = 1'000'000;
};

enum class PathEnd {
  cycle,         ///< back at the sketch
  to_infinity,   ///< far out
  to_undefined,  ///< to a point at which the equations are undefined
  budget         ///< given up: the steps are used up, or none succeeds, as at a critical point
};
/// The words of results.
std::string_view name_of(PathEnd end);

/// A point of the path with t = 1.
struct Crossing {
  std::vector<double> unknowns;
  double length;    ///< from the sketch, negative in the other direction
  double residual;  ///< max |F| there
};

struct SketchPath {
  PathEnd end = PathEnd::budget;        ///< in the first direction
  PathEnd other_end = PathEnd::budget;  ///< in the other one; of a cycle: the same
  std::vector<Crossing> crossings;      ///< in the order met, the first direction first
  double length = 0;
  std::uint64_t steps = 0;
  std::uint64_t refused = 0;  ///< steps tried in vain
};

/// Follows the path through (sketch, 0), where H must vanish up to rounding and its Jacobian have rank m.
/// Throws NotApplicable, with the reason, where that is not so.
SketchPath follow_sketch(Homotopy& homotopy, std::span<const double> sketch, const TrackerOptions& options,
                         const std::stop_token& stop = {});

}  // namespace gcslab
