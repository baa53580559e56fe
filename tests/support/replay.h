#pragma once

// Repeats what a proof trace says was done to a box, without asking why.

#include <gtest/gtest.h>
#include <optional>
#include <span>

#include "box_solver/proof_step.h"

namespace gcslab {

class Replay {
 public:
  explicit Replay(std::span<const ProofStep> steps) : steps_(steps) {}

  /// The box that the steps leave; nothing when they say that it has no root. Checks that no step widens.
  std::optional<Box> run(const Box& box) {
    next_ = 0;
    std::optional<Box> left = part(box);
    EXPECT_EQ(next_, steps_.size()) << "a part without its beginning";
    return left;
  }

 private:
  /// Steps up to the end of the part of a box that is one of two cases, or of everything.
  std::optional<Box> part(std::optional<Box> box) {
    for (; next_ < steps_.size(); ++next_) {
      const ProofStep& step = steps_[next_];
      if (step.argument == Argument::otherwise || step.argument == Argument::join) break;
      if (step.argument == Argument::expansion) continue;
      EXPECT_TRUE(box.has_value()) << "a step on a part that is empty";
      if (!box) return box;
      box = step.argument == Argument::cases ? cases(*box) : narrowed(*box, step);
    }
    return box;
  }

  static std::optional<Box> narrowed(Box box, const ProofStep& step) {
    EXPECT_TRUE(subset(step.result, box[step.variable])) << "a step widens variable " << step.variable;
    if (is_empty(step.result)) return std::nullopt;
    box[step.variable] = step.result;
    return box;
  }

  /// Both parts of a box and the hull of what they leave; ends on the step that joins them.
  std::optional<Box> cases(const Box& box) {
    const ProofStep& step = steps_[next_++];
    const double border = step.result.lower;
    EXPECT_TRUE(box[step.variable].lower < border && border < box[step.variable].upper);
    Box lower = box, upper = box;
    lower[step.variable].upper = border;
    upper[step.variable].lower = border;
    const std::optional<Box> left = part(lower);
    expect(Argument::otherwise);
    ++next_;
    const std::optional<Box> right = part(upper);
    expect(Argument::join);
    if (!left || !right) return left ? left : right;
    Box joined;
    for (std::size_t i = 0; i < box.size(); ++i) joined.push_back(hull((*left)[i], (*right)[i]));
    return joined;
  }

  void expect(Argument argument) const {
    EXPECT_TRUE(next_ < steps_.size() && steps_[next_].argument == argument) << "step " << next_;
  }

  std::span<const ProofStep> steps_;
  std::size_t next_ = 0;
};

}  // namespace gcslab
