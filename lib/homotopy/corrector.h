#pragma once

// From a prediction back to the curve, by Newton's method with one more equation.

#include <string_view>
#include <vector>

#include "homotopy/curve_point.h"

namespace gcslab {

enum class CorrectorKind {
  /// In the hyperplane through the prediction across the last tangent (pseudo arc length), with the matrix
  /// that was factorised at the last point; where that does not contract, as `newton`.
  chord,
  /// In the same hyperplane, a factorisation an iteration.
  newton,
  /// Across the curve's own direction at each iterate: the least change that solves the linearised equations
  /// (Gauss and Newton; normal flow), a factorisation an iteration.
  normal_flow
};

struct CorrectorOptions {
  CorrectorKind kind = CorrectorKind::chord;
  /// Of all changes that would follow, by how those before have contracted, relative to 1 + the largest
  /// coordinate; at most a hundredth of the step.
  double tolerance = 1e-6;
  int iterations = 8;
  /// One change of Newton's method follows, with the matrix of where the correction ends: the tolerance is for
  /// what that leaves, about rate / step times the square of what is left before; that is at most 0.0002
  /// of the step.
  bool is_polished_after = false;
};

/// How a correction went.
struct Correction {
  enum class End { done, no_contraction, undefined };
  End end = End::done;
  double first = 0;  ///< length of the first change: the error of the prediction
  double rate = 0;   ///< largest quotient of changes that follow each other
};

class Corrector {
 public:
  Corrector(Curve& curve, const CorrectorOptions& options);

  /// Moves v, a prediction from `here` at that step, to the curve. `at_here` is (J; border) there.
  Correction correct(const CurvePoint& here, const BorderedMatrix& at_here, double step,
                     std::vector<double>& v);

 private:
  Correction iterate(const CurvePoint& here, const BorderedMatrix* at_here, double step,
                     std::vector<double>& v);
  bool factorise(const std::vector<double>& v, std::span<const double> border);

  Curve* curve_;
  CorrectorOptions options_;
  BorderedMatrix matrix_;
  std::vector<double> values_, zero_, change_, kernel_, predicted_;
  Matrix<double> jacobian_;
};

}  // namespace gcslab
