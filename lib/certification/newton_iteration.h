#pragma once

// Newton's iteration in plain doubles: it finds points worth a proof, and proves nothing.

#include <optional>
#include <span>
#include <vector>

#include "base/matrix.h"
#include "certification/system_functions.h"

namespace gcslab {

/// The approximate inverse of a square matrix; nothing when it is singular to double precision.
std::optional<Matrix<double>> approximate_inverse(const Matrix<double>& matrix);

/// An approximate root with the approximate inverse of the Jacobian there.
struct ApproximateRoot {
  std::vector<double> point;
  Matrix<double> inverse;
};

class NewtonIteration {
 public:
  /// For square systems. `functions` must outlive it. `scales` are the sizes of the variables.
  NewtonIteration(const SystemFunctions& functions, std::vector<double> scales);

  /// Iterates from the midpoint of a bounded box until the steps are as small as rounding allows. Nothing
  /// when an iterate leaves the box by more than half its width, or a small part of the scales or of the
  /// magnitudes where that is larger, or when the Jacobian is singular.
  std::optional<ApproximateRoot> run(const Box& box);

 private:
  /// One step; the largest part of a side's reach that it moves, nothing when it breaks down.
  std::optional<double> step(const Box& box, std::vector<double>& point);
  bool stays_near(const Box& box, std::span<const double> point) const;
  /// The radius of a side, or a small part of its scale or its magnitude when that is larger.
  double reach(std::size_t variable, const Interval& side) const;

  std::vector<double> scales_;
  SystemEvaluator<double> evaluator_;
  std::vector<double> values_;
  Matrix<double> jacobian_;
};

}  // namespace gcslab
