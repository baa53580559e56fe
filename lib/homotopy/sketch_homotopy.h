#pragma once

// The homotopy that deforms a sketch into a figure with the wanted parameters, and where its path starts.

#include <optional>

#include "homotopy/homotopy.h"

namespace gcslab {

enum class Interpolation {
  linear,
  compact_support  ///< of the first distance whose equation tells its sign
};

/// What becomes of constraints without a parameter on the way.
enum class Booleans {
  /// They hold at t = 1 only, and in a sketch that nearly satisfies all of them at t = 0.
  perturbed,
  /// They hold at t = 0 and t = 1 only: the sketch is moved to where they hold.
  projected,
  /// They hold all along, from a sketch that is moved to where they hold.
  kept
};

struct SketchHomotopyOptions {
  Interpolation interpolation = Interpolation::linear;
  Booleans booleans = Booleans::perturbed;
  /// Leading coefficient of the perturbation (1 - t) t where the sketch satisfies boolean constraints.
  double leading = 0.1;
  LinearAlgebra linear_algebra = LinearAlgebra::automatic;
};

class SketchHomotopy {
 public:
  /// `wanted` are the values of the parameters at t = 1. Throws NotApplicable where no figure near the sketch
  /// satisfies the constraints that are to hold there, or for want of a distance with the interpretation
  /// `norm` (compact support); InputError where the sketch has no frame.
  SketchHomotopy(const ConstraintSystem& system, const Frame& frame, const GeometricEquations& equations,
                 const std::vector<double>& wanted, const Figure& sketch,
                 const SketchHomotopyOptions& options = {});

  Homotopy& curve() { return *homotopy_; }
  const Homotopy& curve() const { return *homotopy_; }
  /// The sketch in the frame, with t = 0.
  const std::vector<double>& start() const { return start_; }
  /// The size of the sketch: its largest coordinate in the frame.
  double unit() const { return unit_; }
  /// The size of figures on the way: that of the sketch or, where it is more, the longest wanted distance.
  double extent() const { return extent_; }

 private:
  std::optional<Homotopy> homotopy_;
  std::vector<double> start_;
  double unit_ = 1;
  double extent_ = 1;
};

}  // namespace gcslab
