#pragma once

// The mean value form of a square system, multiplied by a matrix:
//   C f(x) = C f(c) + C J (x - c) for some matrix in J, wherever c and x lie in the box of J.
// With C near the inverse of the Jacobian, C J is near the identity, so that equation i is nearly one for
// variable i alone (Hansen and Smith 1967). Any C is valid.

#include <span>
#include <vector>

#include "base/matrix.h"
#include "certification/system_functions.h"

namespace gcslab {

template <class T>
class PreconditionedForm {
 public:
  /// For square systems. `functions` must outlive it. A NumberTraits<T>::Scope must be alive from here to the
  /// last call.
  explicit PreconditionedForm(const SystemFunctions& functions);

  /// Encloses f at `centre`, a point of the bounded box, and the slopes J of f between points of the box.
  /// False when f may be undefined or discontinuous somewhere in it.
  [[nodiscard]] bool evaluate(const Box& box, std::span<const double> centre);

  /// The approximate inverse of the midpoint of J; nothing when that is singular.
  std::optional<Matrix<double>> midpoint_inverse() const;

  /// Encloses C J and C f(c) for what was evaluated last. Multipliers are finite.
  void precondition(const Matrix<double>& multipliers);

  const Matrix<T>& matrix() const { return matrix_; }       ///< C J
  std::span<const T> values() const { return values_; }     ///< C f(c)
  std::span<const T> offsets() const { return offsets_; }   ///< box - c
  const std::vector<T>& centre() const { return centre_; }  ///< c
  SystemEvaluator<T>& evaluator() { return evaluator_; }
  std::size_t size() const { return offsets_.size(); }

 private:
  SystemEvaluator<T> evaluator_;
  T zero_;
  Matrix<T> slopes_, matrix_;
  std::vector<T> box_, centre_, offsets_, function_values_, values_;
};

/// Encloses sum multipliers[k] values[k].
template <class T>
T combination(std::span<const double> multipliers, std::span<const T> values);

/// Encloses the product C S.
template <class T>
void combine_rows(const Matrix<double>& multipliers, const Matrix<T>& slopes, Matrix<T>& product);

/// True only for a nonsingular matrix: when ||I - C B|| < 1 for its approximate inverse B.
bool is_proved_nonsingular(const Matrix<double>& matrix);

}  // namespace gcslab
