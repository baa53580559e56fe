// Affine arithmetic: first-order correlations between operands are kept as shared noise symbols (Comba,
// Stolfi 1993).

#include "enclosure/bound_registry.h"
#include "enclosure/scoped_evaluator.h"
#include "interval/affine_form.h"

namespace gcslab {
namespace {

template <class Form>
class AffineBound final : public RangeBound {
 public:
  explicit AffineBound(const BoundTarget& target)
      : evaluator_(std::vector<Expression>{target.function()}, target.variables(), 53) {}

  Interval over(const Box& box) override {
    const auto scope = evaluator_.open();
    return NumberTraits<Form>::enclosure(evaluator_.at(box).value());
  }

 private:
  ScopedEvaluator<Form> evaluator_;
};

template <class Form>
std::unique_ptr<RangeBound> make(const BoundTarget& target, const Options&) {
  return std::make_unique<AffineBound<Form>>(target);
}

}  // namespace

BoundVariant affine_chebyshev_bound() {
  return {"affine_chebyshev",
          "affine arithmetic with Chebyshev approximations of nonlinear functions (Stolfi, Figueiredo 1997)",
          "every function",
          1,
          {},
          make<ChebyshevAffine>};
}

BoundVariant affine_min_range_bound() {
  return {"affine_min_range",
          "affine arithmetic with min-range approximations of nonlinear functions (Stolfi, Figueiredo 1997)",
          "every function",
          1,
          {},
          make<MinRangeAffine>};
}

}  // namespace gcslab
