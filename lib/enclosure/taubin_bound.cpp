// Taubin's forms (Taubin 1994): the polynomial around the centre of the box, each side scaled to [-1, 1],
// bounded monomial by monomial.

#include "enclosure/arithmetic_option.h"
#include "enclosure/bound_registry.h"
#include "enclosure/dyadic_slack.h"
#include "enclosure/tensor_walk.h"
#include "polynomial/power.h"

namespace gcslab {
namespace {

template <class T>
class TaubinBound final : public RangeBound {
 public:
  TaubinBound(const Polynomial& polynomial, TaubinVariant variant, int bits)
      : polynomial_(polynomial), variant_(variant), bits_(bits) {}

  Interval over(const Box& box) override {
    const typename NumberTraits<T>::Scope scope(bits_);
    return taubin_range(power_from_polynomial<T>(polynomial_, rational_box(box)), variant_);
  }

  std::unique_ptr<BoundWalk> walk(const Box& domain, int depth) override {
    const typename NumberTraits<T>::Scope scope(bits_);
    auto root = power_from_polynomial<T>(polynomial_, rational_box(domain));
    const Rational slack = dyadic_slack(polynomial_, domain, depth);
    if (slack > 0) root.coefficients().front() = widened(root.coefficients().front(), slack);
    const auto range = [variant = variant_](const PowerTensor<T>& tensor) {
      return taubin_range(tensor, variant);
    };
    return std::make_unique<TensorWalk<T, PowerTensor<T>, decltype(range)>>(std::move(root), range, bits_);
  }

 private:
  Polynomial polynomial_;
  TaubinVariant variant_;
  int bits_;
};

BoundVariant taubin_variant(std::string name, std::string summary, TaubinVariant variant) {
  return {std::move(name),
          std::move(summary),
          "polynomials whose tensor has at most 2^24 coefficients",
          1,
          with_arithmetic_options(),
          [variant](const BoundTarget& target, const Options& options) {
            return make_for_arithmetic(options, [&]<class T>(int bits) -> std::unique_ptr<RangeBound> {
              return std::make_unique<TaubinBound<T>>(target.polynomial(), variant, bits);
            });
          }};
}

}  // namespace

BoundVariant taubin_bound() {
  return taubin_variant(
      "taubin", "Taubin's form: constant term plus and minus the sum of the other coefficients' sizes",
      TaubinVariant::plain);
}

BoundVariant taubin_even_bound() {
  return taubin_variant("taubin_even", "Taubin's form that knows that even powers are not negative",
                        TaubinVariant::even);
}

}  // namespace gcslab
