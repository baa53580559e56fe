#pragma once

// A homotopy whose values are computed in more digits than doubles have.

#include <memory>
#include <vector>

#include "expression/tape_evaluator.h"
#include "homotopy/homotopy.h"
#include "interval/mpfr_interval.h"

namespace gcslab {

/// The same curve: values with that many bits, from tapes, rounded to doubles at the end; derivatives in
/// doubles. Newton's method then finds points as exactly as doubles can say, where terms of the equations
/// cancel, as those of short distances far from the origin, or where the Jacobian is nearly singular
/// (iterative refinement, Skeel 1980).
class PreciseHomotopy final : public Curve {
 public:
  /// Both must outlive it.
  PreciseHomotopy(const GeometricEquations& equations, Homotopy& homotopy, int bits = 128);

  std::size_t size() const override { return homotopy_->size(); }
  bool values(std::span<const double> v, std::span<double> result) override;
  bool jacobian(std::span<const double> v, std::span<double> result, Matrix<double>& derivatives) override;

 private:
  void prepare();

  struct Equation {
    std::unique_ptr<Tape> tape;
    std::unique_ptr<TapeEvaluator<MpfrInterval>> evaluator;
  };

  const GeometricEquations* source_;
  Homotopy* homotopy_;
  int bits_;
  std::vector<Equation> equations_;  ///< empty until they are first needed
  std::vector<double> parameters_, speeds_;
  std::vector<MpfrInterval> x_;
};

}  // namespace gcslab
