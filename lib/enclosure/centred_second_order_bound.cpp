// Taylor form of order two, f(c) + f'(c) (X - c) + (X - c)' H(X) (X - c) / 2 (Ratschek, Rokne 1984, chapter
// 3), with squares of sides taken as squares and H by symbolic differentiation.

#include "enclosure/arithmetic_option.h"
#include "enclosure/bound_registry.h"
#include "enclosure/scoped_evaluator.h"
#include "expression/differentiate.h"

namespace gcslab {
namespace {

std::vector<Expression> value_and_gradient(const BoundTarget& target) {
  std::vector<Expression> outputs{target.function()};
  for (const Expression& partial : gradient(target.function(), target.variables()))
    outputs.push_back(partial);
  return outputs;
}

/// f itself, for its domain, then the upper triangle of the Hessian row by row.
std::vector<Expression> value_and_hessian(const BoundTarget& target) {
  std::vector<Expression> outputs{target.function()};
  for (int i = 0; i < target.variables(); ++i) {
    const Expression partial = differentiate(target.function(), i);
    for (int j = i; j < target.variables(); ++j) outputs.push_back(differentiate(partial, j));
  }
  return outputs;
}

template <class T>
class CentredSecondOrderBound final : public RangeBound {
 public:
  CentredSecondOrderBound(const BoundTarget& target, int bits)
      : over_box_(value_and_hessian(target), target.variables(), bits),
        at_centre_(value_and_gradient(target), target.variables(), bits) {}

  Interval over(const Box& box) override {
    const auto scope = over_box_.open();
    const TapeEvaluator<T>& hessian = over_box_.at(box);
    // Taylor's theorem needs f, f' and f'' on the whole box.
    if (!hessian.defined_everywhere()) return NumberTraits<T>::enclosure(hessian.value(0));
    const std::size_t n = box.size();
    Box centre;
    for (const Interval& side : box) centre.emplace_back(midpoint(side));
    const TapeEvaluator<T>& taylor = at_centre_.at(centre);
    std::vector<T> offset;
    for (std::size_t i = 0; i < n; ++i) offset.push_back(over_box_.point()[i] - at_centre_.point()[i]);
    T sum = taylor.value(0);
    const T half = NumberTraits<T>::from_rational(Rational(1, 2));
    std::size_t entry = 1;
    for (std::size_t i = 0; i < n; ++i) {
      sum = sum + taylor.value(i + 1) * offset[i] + hessian.value(entry++) * (sqr(offset[i]) * half);
      for (std::size_t j = i + 1; j < n; ++j) sum = sum + hessian.value(entry++) * (offset[i] * offset[j]);
    }
    return NumberTraits<T>::enclosure(sum);
  }

 private:
  ScopedEvaluator<T> over_box_;
  ScopedEvaluator<T> at_centre_;
};

std::unique_ptr<RangeBound> make(const BoundTarget& target, const Options& options) {
  return make_for_arithmetic(options, [&]<class T>(int bits) -> std::unique_ptr<RangeBound> {
    return std::make_unique<CentredSecondOrderBound<T>>(target, bits);
  });
}

}  // namespace

BoundVariant centred_second_order_bound() {
  return {"centred_second_order",
          "Taylor form of order two around the midpoint (Ratschek, Rokne 1984)",
          "functions without abs, min and max; where f is not defined on the whole box, the natural "
          "extension stands in",
          1,
          with_arithmetic_options(),
          make};
}

}  // namespace gcslab
