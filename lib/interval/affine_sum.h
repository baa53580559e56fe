#pragma once

// The linear part of an affine form: centre + sum over i of coefficient_i e_i +- error, with noise symbols
// e_i in
// [-1, 1] shared between forms (Comba, Stolfi 1993; de Figueiredo, Stolfi 1997 and 2004).
//
// Promise: inside a NoiseScope, where rounding is upward, each operation encloses: for every value of the
// noise symbols and every point of the operands' error bands, the exact result lies in the band of the
// result. All rounding errors, bounded by the difference of the coefficient rounded up and down, go to
// `error`, which no other form shares.

#include <cstddef>
#include <vector>

#include "interval/interval.h"
#include "interval/rounding.h"

namespace gcslab {

/// While alive, this thread rounds upward and numbers its noise symbols from 0. Values made in a scope must
/// not be used outside of it, nor in a scope nested in it: their symbols would be taken for others.
/// Constants, which have none, may.
class NoiseScope {
 public:
  NoiseScope();
  ~NoiseScope();
  NoiseScope(const NoiseScope&) = delete;
  NoiseScope& operator=(const NoiseScope&) = delete;

 private:
  UpwardRounding upward_;
  std::size_t saved_;
};

class AffineSum {
 public:
  /// The number 0.
  AffineSum() = default;
  /// A bounded interval as centre +- error: right for constants.
  static AffineSum constant(const Interval& x);
  /// A bounded interval as centre + radius e with a new symbol e: right for variables. A single number takes
  /// none.
  static AffineSum variable(const Interval& x);

  double centre() const { return centre_; }
  bool is_constant() const { return coefficients_.empty(); }
  /// False after an overflow: then the sum says nothing.
  bool is_finite() const;
  /// Bound of |sum - centre|.
  double radius() const;
  Interval range() const;
  /// Number of noise symbols that may have a coefficient other than 0.
  std::size_t symbols() const { return coefficients_.size(); }
  /// Coefficient of the i-th noise symbol of the scope.
  double coefficient(std::size_t i) const { return i < coefficients_.size() ? coefficients_[i] : 0; }
  double error() const { return error_; }

  AffineSum operator-() const;
  /// slope * x + [offset], the offset as a new symbol unless x is a constant.
  static AffineSum linear(double slope, const AffineSum& x, const Interval& offset);
  static AffineSum sum(const AffineSum& x, const AffineSum& y);
  static AffineSum difference(const AffineSum& x, const AffineSum& y);
  /// The quadratic remainder, as a new symbol, is (sum x_i y_i)/2 +- (r_x r_y - (sum |x_i y_i|)/2), because
  /// e_i^2 lies in [0, 1] and all other products of symbols in [-1, 1].
  static AffineSum product(const AffineSum& x, const AffineSum& y);

 private:
  /// The symbols' part of alpha x + beta y; the centre stays 0.
  static AffineSum combined(double alpha, const AffineSum& x, double beta, const AffineSum& y);
  /// Adds an interval to the centre and its radius to the error.
  void shift(const Interval& amount);
  void add_new_symbol(double radius);

  double centre_ = 0;
  double error_ = 0;
  std::vector<double> coefficients_;  // padded with zeros to a multiple of four
};

}  // namespace gcslab
