#pragma once

// The midpoints of a model as exact rationals: one list of constraints, columns first, then rows.

#include <cstddef>
#include <optional>
#include <vector>

#include "linear_program/exact_factorisation.h"
#include "linear_program/lp_model.h"

namespace gcslab {

struct ExactConstraint {
  ExactFactorisation::SparseRow normal;
  std::optional<Rational> lower;
  std::optional<Rational> upper;

  bool is_equation() const { return lower && upper && *lower == *upper; }
  /// normal . point.
  Rational value(const std::vector<Rational>& point) const;
};

class ExactProgram {
 public:
  explicit ExactProgram(const LpModel& model);

  std::size_t columns() const { return columns_; }
  const std::vector<ExactConstraint>& constraints() const { return constraints_; }
  /// The midpoints of an objective's coefficients, one a column.
  std::vector<Rational> cost(std::span<const LinearTerm> objective) const;

 private:
  std::size_t columns_;
  std::vector<ExactConstraint> constraints_;
};

}  // namespace gcslab
