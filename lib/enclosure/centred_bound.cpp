// Mean value form f(c) + f'(X) (X - c) (Moore 1966), with one centre or with the two that are optimal for the
// two ends (Baumann 1988).

#include "enclosure/arithmetic_option.h"
#include "enclosure/bound_registry.h"
#include "enclosure/scoped_evaluator.h"

namespace gcslab {
namespace {

struct CentredSettings {
  bool bicentred;
  bool reverse_mode;
};

/// The centre that makes the lower end of the mean value form greatest, for a slope in [a, b] on a side
/// (Baumann 1988). Any centre in the side is valid, so this needs no care for rounding beyond staying inside.
double lower_optimal_centre(const Interval& side, const Interval& slope) {
  if (slope.lower >= 0) return side.lower;
  if (slope.upper <= 0) return side.upper;
  if (!is_bounded(slope)) return midpoint(side);
  const double centre = (slope.upper * side.lower - slope.lower * side.upper) / (slope.upper - slope.lower);
  return contains(side, centre) ? centre : midpoint(side);
}

double upper_optimal_centre(const Interval& side, const Interval& slope) {
  return lower_optimal_centre(side, {-slope.upper, -slope.lower});
}

template <class T>
class CentredBound final : public RangeBound {
 public:
  CentredBound(const BoundTarget& target, CentredSettings settings, int bits)
      : settings_(settings),
        over_box_(std::vector<Expression>{target.function()}, target.variables(), bits),
        at_centre_(std::vector<Expression>{target.function()}, target.variables(), bits) {}

  Interval over(const Box& box) override {
    const auto scope = over_box_.open();
    TapeEvaluator<T>& values = over_box_.at(box);
    const Interval natural = NumberTraits<T>::enclosure(values.value());
    // The mean value theorem needs f on the whole box; where f is not defined everywhere the natural
    // extension stands.
    if (!values.defined_everywhere()) return natural;
    const auto gradient = settings_.reverse_mode ? values.reverse_gradient() : values.forward_gradient();
    if (!settings_.bicentred) return around(centre_of(box), box, gradient);
    return intersection(around(optimal_centre(box, gradient, lower_optimal_centre), box, gradient),
                        around(optimal_centre(box, gradient, upper_optimal_centre), box, gradient));
  }

 private:
  static Box centre_of(const Box& box) {
    Box centre;
    for (const Interval& side : box) centre.emplace_back(midpoint(side));
    return centre;
  }

  template <class Choice>
  static Box optimal_centre(const Box& box, std::span<const T> gradient, Choice choice) {
    Box centre;
    for (std::size_t i = 0; i < box.size(); ++i) {
      centre.emplace_back(choice(box[i], NumberTraits<T>::enclosure(gradient[i])));
    }
    return centre;
  }

  Interval around(const Box& centre, const Box& box, std::span<const T> gradient) {
    T sum = at_centre_.at(centre).value();
    for (std::size_t i = 0; i < box.size(); ++i) {
      sum = sum + gradient[i] * (over_box_.point()[i] - at_centre_.point()[i]);
    }
    return NumberTraits<T>::enclosure(sum);
  }

  CentredSettings settings_;
  ScopedEvaluator<T> over_box_;
  ScopedEvaluator<T> at_centre_;
};

std::unique_ptr<RangeBound> make(const BoundTarget& target, const Options& options) {
  const CentredSettings settings{options.word("centre") == "bicentred",
                                 options.word("derivatives") == "reverse"};
  return make_for_arithmetic(options, [&]<class T>(int bits) -> std::unique_ptr<RangeBound> {
    return std::make_unique<CentredBound<T>>(target, settings, bits);
  });
}

}  // namespace

BoundVariant centred_bound() {
  return {"centred",
          "mean value form with gradients by automatic differentiation (Moore 1966; centres: Baumann 1988)",
          "every function; where f is not defined on the whole box, the natural extension stands in",
          1,
          with_arithmetic_options(
              {choice_option("centre", "midpoint, or the two centres that are optimal for the two ends",
                             "midpoint", {"midpoint", "bicentred"}),
               choice_option("derivatives", "mode of automatic differentiation", "reverse",
                             {"reverse", "forward"})}),
          make};
}

}  // namespace gcslab
