#pragma once

// Walks that pass the coefficients of a polynomial from a box to its halves: de Casteljau in the Bernstein
// basis, a Taylor shift in the power basis.

#include <memory>
#include <vector>

#include "enclosure/range_bound.h"
#include "interval/number_traits.h"

namespace gcslab {

/// The current tensor of a walk. TensorType has halve(variable, lower, upper).
template <class TensorType>
class TensorPath {
 public:
  explicit TensorPath(TensorType root) : root_(std::move(root)), steps_(1) {}

  const TensorType& current() const { return depth_ == 0 ? root_ : steps_[depth_ - 1].taken(); }

  /// The halves of a box are computed once, when the first of them is entered. A scope must be open.
  void enter(std::size_t variable, Half half) {
    if (steps_.size() <= depth_) steps_.resize(depth_ + 1);
    Step& step = steps_[depth_];
    if (!step.is_split || step.variable != variable) {
      current().halve(static_cast<int>(variable), step.lower, step.upper);
      step.is_split = true;
      step.variable = variable;
    }
    step.half = half;
    ++depth_;
    if (depth_ < steps_.size()) steps_[depth_].is_split = false;
  }

  void leave() { --depth_; }

 private:
  struct Step {
    TensorType lower, upper;
    std::size_t variable = 0;
    Half half = Half::lower;
    bool is_split = false;
    const TensorType& taken() const { return half == Half::lower ? lower : upper; }
  };

  TensorType root_;
  std::vector<Step> steps_;
  std::size_t depth_ = 0;
};

/// A walk that bounds the current tensor by a function of it.
template <class T, class TensorType, class Range>
class TensorWalk final : public BoundWalk {
 public:
  TensorWalk(TensorType root, Range range, int bits) : path_(std::move(root)), range_(range), bits_(bits) {}

  void enter(std::size_t variable, Half half) override {
    const typename NumberTraits<T>::Scope scope(bits_);
    path_.enter(variable, half);
  }
  void leave() override { path_.leave(); }
  Interval bound(const Box&) override {
    const typename NumberTraits<T>::Scope scope(bits_);
    return range_(path_.current());
  }

 private:
  TensorPath<TensorType> path_;
  Range range_;
  int bits_;
};

/// Widens numbers by [-slack, slack]. A scope must be open.
template <class T>
T widened(const T& number, const Rational& slack) {
  const T size = NumberTraits<T>::from_rational(slack);
  return number + NumberTraits<T>::from_interval(Interval(-1, 1)) * size;
}

}  // namespace gcslab
