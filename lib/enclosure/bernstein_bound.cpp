// Range by Bernstein coefficients (Cargo, Shisha 1966; Lane, Riesenfeld 1981): p lies between its least and
// its largest coefficient, and an end that stands at a corner is attained.

#include "enclosure/arithmetic_option.h"
#include "enclosure/bound_registry.h"
#include "enclosure/dyadic_slack.h"
#include "enclosure/tensor_walk.h"
#include "polynomial/bernstein.h"

namespace gcslab {
namespace {

template <class T>
class BernsteinBound final : public RangeBound {
 public:
  BernsteinBound(const Polynomial& polynomial, int bits) : polynomial_(polynomial), bits_(bits) {}

  Interval over(const Box& box) override {
    const typename NumberTraits<T>::Scope scope(bits_);
    return bernstein_from_polynomial<T>(polynomial_, rational_box(box)).range();
  }

  std::unique_ptr<BoundWalk> walk(const Box& domain, int depth) override {
    const typename NumberTraits<T>::Scope scope(bits_);
    auto root = bernstein_from_polynomial<T>(polynomial_, rational_box(domain));
    const Rational slack = dyadic_slack(polynomial_, domain, depth);
    if (slack > 0) {
      for (T& coefficient : root.coefficients()) coefficient = widened(coefficient, slack);
    }
    const auto range = [](const BernsteinTensor<T>& tensor) { return tensor.range(); };
    return std::make_unique<TensorWalk<T, BernsteinTensor<T>, decltype(range)>>(std::move(root), range,
                                                                                bits_);
  }

 private:
  Polynomial polynomial_;
  int bits_;
};

std::unique_ptr<RangeBound> make(const BoundTarget& target, const Options& options) {
  return make_for_arithmetic(options, [&]<class T>(int bits) -> std::unique_ptr<RangeBound> {
    return std::make_unique<BernsteinBound<T>>(target.polynomial(), bits);
  });
}

}  // namespace

BoundVariant bernstein_bound() {
  return {"bernstein",
          "least and largest tensor Bernstein coefficient, halved by de Casteljau (Cargo, Shisha 1966)",
          "polynomials whose tensor has at most 2^24 coefficients",
          1,
          with_arithmetic_options(),
          make};
}

}  // namespace gcslab
