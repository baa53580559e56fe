// Where a dear part of a composition is called.

#include "box_solver/fixpoint_contractor.h"

#include <gtest/gtest.h>

namespace gcslab {
namespace {

/// Takes a share off the upper end of the first side; empties boxes that end below a threshold.
class Shrinker final : public Contractor {
 public:
  Shrinker(double cost, double share, double threshold, int& calls)
      : cost_(cost), last_cost_(cost), share_(share), threshold_(threshold), calls_(calls) {}
  /// What a call costs in fact.
  double& last_cost_of_calls() { return last_cost_; }
  double cost() const override { return cost_; }
  double last_cost() const override { return last_cost_; }
  bool contract(Box& box, ProofTrace& /*trace*/) override {
    ++calls_;
    if (box[0].upper < threshold_) return false;
    box[0].upper = box[0].lower + (1 - share_) * width(box[0]);
    return true;
  }

 private:
  double cost_, last_cost_, share_, threshold_;
  int& calls_;
};

struct Composition {
  int cheap_calls = 0, dear_calls = 0;
  std::unique_ptr<Contractor> contractor;
  Shrinker* dear = nullptr;

  Composition(double relative_cost, double dear_share, double cost_in_fact)
      : Composition(relative_cost, dear_share) {
    dear->last_cost_of_calls() = cost_in_fact;
  }
  Composition(double relative_cost, double dear_share) {
    std::vector<CompositionPart> parts;
    parts.push_back({std::make_unique<Shrinker>(1, 0.0, 1.0, cheap_calls), false});
    auto part = std::make_unique<Shrinker>(relative_cost, dear_share, 0.0, dear_calls);
    dear = part.get();
    parts.push_back({std::move(part), true});
    contractor = make_fixpoint_contractor(std::move(parts), 0.9, 50);
  }
  /// What one box adds.
  Experience after(const Box& box, const Experience& so_far, std::uint64_t number) {
    Box left = box;
    ProofTrace trace;
    contractor->learn(so_far, number);
    static_cast<void>(contractor->contract(left, trace));
    return contractor->experience();
  }
};

const Box kLarge = {{0, 1024}};

TEST(DearPart, IsTriedOnBoxesWhoseNumberIsAPowerOfTwoOnceTheyAreManyEnough) {
  Composition composition(64, 0.5);
  const Experience nothing;
  for (std::uint64_t number = 0; number <= 256; ++number)
    static_cast<void>(composition.after(kLarge, nothing, number));
  EXPECT_EQ(composition.dear_calls, 5);  // 16, 32, 64, 128, 256
}

TEST(DearPart, IsCalledWhereItPaidAndBoxesAreFarLargerThanLeaves) {
  Composition composition(8, 0.875);  // 3 halvings a call
  Experience so_far = composition.after(kLarge, Experience(), 8);
  EXPECT_EQ(so_far.dear[0].calls, 1);
  EXPECT_NEAR(so_far.dear[0].halvings, 3, 1e-12);
  so_far += composition.after({{0, 0.5}}, so_far, 9);
  EXPECT_EQ(so_far.leaves, 1);
  EXPECT_EQ(so_far.leaf_size, -1);
  // 11 halvings and 2 levels are ahead of a box of size 10: 13 levels of one halving or 13/4 of four, and
  // 13 - 13/4 > log2(1 + 8). Of a box of size 0 only 3 are: 3 - 3/4 < log2(9).
  EXPECT_EQ(composition.after(kLarge, so_far, 11).dear[0].calls, 1);
  EXPECT_EQ(composition.after({{0, 1}}, so_far, 11).dear[0].calls, 0);
}

TEST(DearPart, IsLeftOutWhereItCostsMoreThanItSeemed) {
  Composition composition(8, 0.875, 1 << 20);
  Experience so_far = composition.after(kLarge, Experience(), 8);
  EXPECT_EQ(so_far.dear[0].calls, 1);
  EXPECT_EQ(so_far.dear[0].cost, 1 << 20);
  so_far += composition.after({{0, 0.5}}, so_far, 9);
  EXPECT_EQ(composition.after(kLarge, so_far, 11).dear[0].calls, 0);
}

TEST(DearPart, IsLeftOutWhereItGainedNothing) {
  Composition composition(8, 0.0);
  Experience so_far = composition.after(kLarge, Experience(), 8);
  EXPECT_EQ(so_far.dear[0].calls, 1);
  EXPECT_EQ(so_far.dear[0].halvings, 0);
  EXPECT_EQ(composition.after(kLarge, so_far, 11).dear[0].calls, 0);
  EXPECT_EQ(composition.after(kLarge, so_far, 16).dear[0].calls, 1);  // but tried again
}

TEST(DearPart, IsDroppedWhereItCostsTooMuchEver) {
  Composition composition(513, 0.5);
  static_cast<void>(composition.after(kLarge, Experience(), 1024));
  EXPECT_EQ(composition.dear_calls, 0);
  EXPECT_GT(composition.cheap_calls, 0);
}

TEST(Experience, AddsUp) {
  Experience a, b;
  a.boxes = 1;
  a.dear[1] = {.boxes = 1, .calls = 2, .cost = 4, .halvings = 3};
  b.boxes = 2;
  b.rounds = 5;
  b.halvings = 7;
  b.leaves = 11;
  b.leaf_size = 13;
  b.dear[1] = {.boxes = 10, .calls = 20, .cost = 40, .halvings = 30};
  a += b;
  EXPECT_EQ(a.boxes, 3);
  EXPECT_EQ(a.rounds, 5);
  EXPECT_EQ(a.halvings, 7);
  EXPECT_EQ(a.leaves, 11);
  EXPECT_EQ(a.leaf_size, 13);
  EXPECT_EQ(a.dear[1].boxes, 11);
  EXPECT_EQ(a.dear[1].calls, 22);
  EXPECT_EQ(a.dear[1].cost, 44);
  EXPECT_EQ(a.dear[1].halvings, 33);
  EXPECT_EQ(a.dear[0].boxes, 0);
}

}  // namespace
}  // namespace gcslab
