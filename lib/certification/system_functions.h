#pragma once

// A system of equations and inequalities compiled for evaluation over boxes.
//
// SystemFunctions is what is known of the functions before any box: read by all threads. SystemEvaluator
// runs them over one number type and belongs to one thread; a NumberTraits<T>::Scope must be alive from its
// construction to its last call.

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "base/matrix.h"
#include "expression/equation_system.h"
#include "expression/tape_evaluator.h"
#include "polynomial/polynomial.h"

namespace gcslab {

/// One function of a system.
struct SystemFunction {
  Expression expression;
  Tape tape;
  std::vector<std::size_t> variables;    ///< those that occur, ascending
  std::optional<Polynomial> polynomial;  ///< when it is one, of moderate size
  int degree;                            ///< total degree of the polynomial; -1 without one
};

class SystemFunctions {
 public:
  explicit SystemFunctions(EquationSystem system);

  std::size_t variables() const { return system_.variables.size(); }
  const EquationSystem& system() const { return system_; }
  const std::vector<SystemFunction>& equations() const { return equations_; }        ///< each is to vanish
  const std::vector<SystemFunction>& inequalities() const { return inequalities_; }  ///< each is to be <= 0
  /// How many equations there are that are not 0 = 0.
  std::size_t constraints() const;
  bool is_square() const { return equations_.size() == variables(); }

 private:
  EquationSystem system_;
  std::vector<SystemFunction> equations_;
  std::vector<SystemFunction> inequalities_;
};

template <class T>
class SystemEvaluator {
 public:
  /// `functions` must outlive it.
  explicit SystemEvaluator(const SystemFunctions& functions);

  const SystemFunctions& functions() const { return *functions_; }

  /// Encloses each equation's values over the box.
  void values(std::span<const T> box, std::span<T> result);

  /// Encloses the slopes of each equation between points of the box, hence its derivatives there: for p, q in
  /// the box f(p) - f(q) = S (p - q) with S in the matrix. False when an equation may be undefined or
  /// discontinuous somewhere in the box; the matrix says nothing then.
  [[nodiscard]] bool jacobian(std::span<const T> box, Matrix<T>& result);

  /// Encloses the slopes of each equation from points of `centre` to points of `box`, which need not contain
  /// it: for c in centre, p in box f(p) - f(c) = S (p - c) with S in the matrix. Half as wide as the
  /// Jacobian over the hull for equations of degree 2, whose slope is the gradient at (p + c) / 2. False as
  /// for jacobian.
  [[nodiscard]] bool slopes(std::span<const T> box, std::span<const T> centre, Matrix<T>& result);

 private:
  /// Gradient of one equation over a box into a row.
  bool gradient(std::size_t equation, std::span<const T> box, std::span<T> row);

  const SystemFunctions* functions_;
  std::vector<TapeEvaluator<T>> evaluators_;
  T zero_, half_;
  std::vector<T> between_, around_;
};

}  // namespace gcslab
