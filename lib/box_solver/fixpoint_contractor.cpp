#include "box_solver/fixpoint_contractor.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/check.h"

namespace gcslab {
namespace {

/// The sum over the sides of log2(width before / width after): how many halvings a contraction saved.
double halvings(const Box& before, const Box& after) {
  double sum = 0;
  for (std::size_t i = 0; i < before.size(); ++i) {
    const double ratio = width(before[i]) / width(after[i]);
    if (ratio > 1) sum += std::isfinite(ratio) ? std::log2(ratio) : 60;
  }
  return sum;
}

/// One dear part's record in the memory: failures in a row, and levels left to leave it out.
struct Record {
  unsigned failures;
  unsigned waiting;
};

class Records {
 public:
  static constexpr std::size_t kMaximum = 2;

  explicit Records(ContractorMemory memory) {
    for (std::size_t i = 0; i < kMaximum; ++i)
      records_[i] = {(memory >> (16 * i + 8)) & 255U, (memory >> (16 * i)) & 255U};
  }
  ContractorMemory packed() const {
    ContractorMemory memory = 0;
    for (std::size_t i = 0; i < kMaximum; ++i)
      memory |= (records_[i].failures << 8U | records_[i].waiting) << (16 * i);
    return memory;
  }

  /// Whether the part has its turn on this level.
  bool take_turn(std::size_t part) {
    if (records_[part].waiting == 0) return true;
    --records_[part].waiting;
    return false;
  }
  void tell(std::size_t part, bool has_paid) {
    constexpr unsigned kMostFailures = 3;
    Record& record = records_[part];
    record.failures = has_paid ? 0 : std::min(record.failures + 1, kMostFailures);
    record.waiting = record.failures == 0 ? 0 : (1U << (2 * record.failures - 1)) - 1;
  }

 private:
  std::array<Record, kMaximum> records_{};
};

class FixpointContractor final : public Contractor {
 public:
  FixpointContractor(std::vector<CompositionPart> parts, double ratio, int maximum_rounds)
      : ratio_(ratio), maximum_rounds_(maximum_rounds) {
    for (CompositionPart& part : parts) {
      if (!part.is_dear) cost_ += part.contractor->cost();
      (part.is_dear ? dear_ : cheap_).push_back(std::move(part.contractor));
    }
    std::erase_if(dear_, [&](const auto& part) { return worth(*part) > kHopeless; });
    GCSLAB_CHECK(dear_.size() <= Records::kMaximum);
  }

  double cost() const override { return cost_; }
  void recall(ContractorMemory memory) override { records_ = Records(memory); }
  ContractorMemory memory() const override { return records_.packed(); }

  bool contract(Box& box, ProofTrace& trace) override {
    std::array<bool, Records::kMaximum> has_turn{};
    for (std::size_t i = 0; i < dear_.size(); ++i) has_turn[i] = records_.take_turn(i);
    int rounds = 0;
    bool goes_on = true;
    while (goes_on) {
      if (!apply_cheap(box, trace, rounds)) return false;
      goes_on = false;
      for (std::size_t i = 0; i < dear_.size() && !goes_on; ++i) {
        if (!has_turn[i]) continue;
        start_ = box;
        if (!dear_[i]->contract(box, trace)) {
          // The boxes below are gone; nobody reads the memory.
          return false;
        }
        has_turn[i] = halvings(start_, box) >= worth(*dear_[i]);
        records_.tell(i, has_turn[i]);
        goes_on = rounds < maximum_rounds_ && largest_gain(start_, box) >= ratio_;
      }
    }
    return true;
  }

 private:
  static constexpr double kHopeless = 9;  ///< no contraction saves that many halvings again and again

  bool apply_cheap(Box& box, ProofTrace& trace, int& rounds) {
    do {
      before_ = box;
      for (const auto& part : cheap_) {
        if (!part->contract(box, trace)) return false;
      }
    } while (++rounds < maximum_rounds_ && largest_gain(before_, box) >= ratio_);
    return true;
  }

  double worth(const Contractor& dear) const {
    return cost_ > 0 ? std::max(0.0, std::log2(dear.cost() / cost_)) : 0;
  }

  std::vector<std::unique_ptr<Contractor>> cheap_, dear_;
  double ratio_;
  int maximum_rounds_;
  double cost_ = 0;
  Records records_{0};
  Box before_, start_;
};

}  // namespace

std::unique_ptr<Contractor> make_fixpoint_contractor(std::vector<CompositionPart> parts, double ratio,
                                                     int maximum_rounds) {
  return std::make_unique<FixpointContractor>(std::move(parts), ratio, maximum_rounds);
}

}  // namespace gcslab
