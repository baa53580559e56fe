#pragma once

// A curve in R^(m+1) over boxes, in outward rounded arithmetic: what a proof about a curve needs.

#include <memory>
#include <span>
#include <vector>

#include "base/matrix.h"
#include "expression/tape_evaluator.h"
#include "homotopy/homotopy.h"
#include "interval/fast_interval.h"

namespace gcslab {

/// To be used inside a NumberTraits<FastInterval>::Scope.
class IntervalCurve {
 public:
  virtual ~IntervalCurve() = default;
  /// m: the number of equations.
  virtual std::size_t size() const = 0;
  /// Encloses H over the box. False where some equation may be undefined in it.
  virtual bool values(std::span<const FastInterval> v, std::span<FastInterval> result) = 0;
  /// Encloses the m by m + 1 Jacobian over the box. False where some equation may be undefined or not smooth.
  virtual bool jacobian(std::span<const FastInterval> v, Matrix<FastInterval>& result) = 0;
};

/// The curve of a homotopy: the zeros are the same, up to the rounding errors of its coefficients.
class IntervalHomotopy final : public IntervalCurve {
 public:
  /// Both must outlive it.
  IntervalHomotopy(const GeometricEquations& equations, const Homotopy& homotopy);

  std::size_t size() const override { return equations_.size(); }
  bool values(std::span<const FastInterval> v, std::span<FastInterval> result) override;
  bool jacobian(std::span<const FastInterval> v, Matrix<FastInterval>& result) override;

 private:
  struct Equation {
    std::unique_ptr<Tape> tape;
    std::unique_ptr<TapeEvaluator<FastInterval>> evaluator;
  };

  void move_to(std::span<const FastInterval> v);

  const Homotopy* homotopy_;
  std::vector<Equation> equations_;
  std::vector<FastInterval> x_;      ///< unknowns, then parameters
  std::vector<FastInterval> speed_;  ///< of x_ by the coordinate of the curve that moves it
};

}  // namespace gcslab
