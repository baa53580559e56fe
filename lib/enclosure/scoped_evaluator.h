#pragma once

// A tape with its evaluator over a number type whose scope is opened for each use, not kept alive.

#include <span>
#include <vector>

#include "expression/tape_evaluator.h"
#include "interval/number_traits.h"

namespace gcslab {

template <class T>
class ScopedEvaluator {
 public:
  using Scope = typename NumberTraits<T>::Scope;

  ScopedEvaluator(std::span<const Expression> outputs, int variables, int bits)
      : bits_(bits), tape_(outputs, variables), evaluator_(with_constants(tape_, bits)) {}
  ScopedEvaluator(const ScopedEvaluator&) = delete;
  ScopedEvaluator& operator=(const ScopedEvaluator&) = delete;

  /// The scope in which the evaluator may be used and numbers of type T may be made.
  Scope open() const { return Scope(bits_); }

  /// Runs the tape on a box. A scope must be open.
  TapeEvaluator<T>& at(const Box& box) {
    point_.clear();
    for (const Interval& side : box) point_.push_back(NumberTraits<T>::from_interval(side));
    evaluator_.evaluate(point_);
    return evaluator_;
  }
  const std::vector<T>& point() const { return point_; }

 private:
  static TapeEvaluator<T> with_constants(const Tape& tape, int bits) {
    const Scope scope(bits);
    return TapeEvaluator<T>(tape);
  }

  int bits_;
  Tape tape_;
  TapeEvaluator<T> evaluator_;
  std::vector<T> point_;
};

}  // namespace gcslab
