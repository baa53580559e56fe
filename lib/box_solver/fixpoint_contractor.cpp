#include "box_solver/fixpoint_contractor.h"

namespace gcslab {
namespace {

class FixpointContractor final : public Contractor {
 public:
  FixpointContractor(std::vector<std::unique_ptr<Contractor>> parts, double ratio, int maximum_rounds)
      : parts_(std::move(parts)), ratio_(ratio), maximum_rounds_(maximum_rounds) {}

  bool contract(Box& box, ProofTrace& trace) override {
    for (int round = 0; round < maximum_rounds_; ++round) {
      before_ = box;
      for (const auto& part : parts_) {
        if (!part->contract(box, trace)) return false;
      }
      if (largest_gain(before_, box) < ratio_) break;
    }
    return true;
  }

 private:
  std::vector<std::unique_ptr<Contractor>> parts_;
  double ratio_;
  int maximum_rounds_;
  Box before_;
};

}  // namespace

std::unique_ptr<Contractor> make_fixpoint_contractor(std::vector<std::unique_ptr<Contractor>> parts,
                                                     double ratio, int maximum_rounds) {
  return std::make_unique<FixpointContractor>(std::move(parts), ratio, maximum_rounds);
}

}  // namespace gcslab
