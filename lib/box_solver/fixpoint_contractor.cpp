#include "box_solver/fixpoint_contractor.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/check.h"

namespace gcslab {
namespace {

/// log2 of the volume. Sides below a millionth count as that: what is left of them is no matter of cuts.
double size_of(const Box& box) {
  constexpr double kNarrow = 0x1p-20, kWide = 0x1p+40;
  double size = 0;
  for (const Interval& side : box) {
    const double narrow = kNarrow * std::clamp(magnitude(side), 1.0, kWide);
    size += std::log2(std::clamp(width(side), narrow, kWide));
  }
  return size;
}

bool is_power_of_2(std::uint64_t n) { return n != 0 && (n & (n - 1)) == 0; }

class FixpointContractor final : public Contractor {
 public:
  FixpointContractor(std::vector<CompositionPart> parts, double ratio, int maximum_rounds)
      : ratio_(ratio), maximum_rounds_(maximum_rounds) {
    for (CompositionPart& part : parts) {
      if (!part.is_dear) cost_ += part.contractor->cost();
      (part.is_dear ? dear_ : cheap_).push_back(std::move(part.contractor));
    }
    std::erase_if(dear_, [&](const auto& part) { return relative_cost(*part) > kHopeless; });
    GCSLAB_CHECK(dear_.size() <= Experience::kDearParts);
  }

  double cost() const override { return cost_; }
  void learn(const Experience& so_far, std::uint64_t box_number) override {
    so_far_ = &so_far;
    box_number_ = box_number;
  }
  Experience experience() const override { return seen_; }

  bool contract(Box& box, ProofTrace& trace) override {
    seen_ = {};
    rounds_ = 0;
    const double size = size_of(box);
    if (!apply_cheap(box, trace)) {
      seen_.leaves = 1;
      seen_.leaf_size = size;
      return false;
    }
    const double left = size_of(box);
    seen_.boxes = 1;
    seen_.rounds = rounds_;
    seen_.halvings = size - left;
    std::array<bool, Experience::kDearParts> has_turn{};
    for (std::size_t i = 0; i < dear_.size(); ++i) has_turn[i] = is_tried(i) || pays(i, left);
    bool goes_on = true;
    while (goes_on) {
      goes_on = false;
      for (std::size_t i = 0; i < dear_.size() && !goes_on; ++i) {
        if (!has_turn[i]) continue;
        start_ = box;
        if (!apply_dear(i, box, trace)) return false;
        goes_on = rounds_ < maximum_rounds_ && largest_gain(start_, box) >= ratio_;
      }
    }
    return true;
  }

 private:
  /// No contraction saves so much again and again.
  static constexpr double kHopeless = 512;

  bool apply_cheap(Box& box, ProofTrace& trace) {
    do {
      before_ = box;
      for (const auto& part : cheap_) {
        if (!part->contract(box, trace)) return false;
      }
    } while (++rounds_ < maximum_rounds_ && largest_gain(before_, box) >= ratio_);
    return true;
  }

  /// The dear part, and the cheap ones where it shrank the box much.
  bool apply_dear(std::size_t i, Box& box, ProofTrace& trace) {
    DearPartExperience& seen = seen_.dear[i];
    const double size = size_of(box);
    seen.boxes = 1;
    const bool may_have_roots = dear_[i]->contract(box, trace);
    ++seen.calls;
    seen.cost += dear_[i]->last_cost();
    if (!may_have_roots || (largest_gain(start_, box) >= ratio_ && !apply_cheap(box, trace))) {
      seen.halvings += halvings_ahead(size);
      return false;
    }
    seen.halvings += size - size_of(box);
    return true;
  }

  double relative_cost(const Contractor& dear) const { return cost_ > 0 ? dear.cost() / cost_ : 0; }

  /// A trial may cost a few times what the search did before.
  bool is_tried(std::size_t i) const {
    constexpr double kShare = 0.25;
    return is_power_of_2(box_number_) &&
           static_cast<double>(box_number_) >= kShare * relative_cost(*dear_[i]);
  }

  /// How many halvings a box needs until it falls to a cheap part: what it is larger than a typical leaf, and
  /// since it did not fall yet, some levels at least.
  double halvings_ahead(double size) const {
    constexpr double kLevels = 2;
    const double leaf = so_far_->leaves > 0 ? so_far_->leaf_size / so_far_->leaves : size;
    return std::max(0.0, size - leaf) + kLevels * halvings_a_level();
  }
  double halvings_a_level() const {
    return 1 + (so_far_->boxes > 0 ? so_far_->halvings / so_far_->boxes : 0);
  }

  bool pays(std::size_t i, double size) const {
    const DearPartExperience& part = so_far_->dear[i];
    if (part.boxes == 0 || so_far_->boxes == 0) return false;
    const double cheap_cost = cost_ * so_far_->rounds / so_far_->boxes;
    const double cost = cheap_cost > 0 ? part.cost / part.boxes / cheap_cost : 0;
    const double levels = halvings_a_level();
    const double with_part = levels + part.halvings / part.boxes;
    const double ahead = halvings_ahead(size);
    return ahead / levels - ahead / with_part >= std::log2(1 + cost);
  }

  std::vector<std::unique_ptr<Contractor>> cheap_, dear_;
  double ratio_;
  int maximum_rounds_;
  double cost_ = 0;
  Experience nothing_;
  const Experience* so_far_ = &nothing_;
  std::uint64_t box_number_ = 0;
  Experience seen_;
  int rounds_ = 0;
  Box before_, start_;
};

}  // namespace

std::unique_ptr<Contractor> make_fixpoint_contractor(std::vector<CompositionPart> parts, double ratio,
                                                     int maximum_rounds) {
  return std::make_unique<FixpointContractor>(std::move(parts), ratio, maximum_rounds);
}

}  // namespace gcslab
