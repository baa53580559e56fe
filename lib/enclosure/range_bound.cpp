#include "enclosure/range_bound.h"

namespace gcslab {
namespace {

class AnewWalk final : public BoundWalk {
 public:
  explicit AnewWalk(RangeBound& bound) : bound_(bound) {}
  void enter(std::size_t, Half) override {}
  void leave() override {}
  Interval bound(const Box& box) override { return bound_.over(box); }

 private:
  RangeBound& bound_;
};

}  // namespace

std::unique_ptr<BoundWalk> RangeBound::walk(const Box&, int) { return std::make_unique<AnewWalk>(*this); }

}  // namespace gcslab
