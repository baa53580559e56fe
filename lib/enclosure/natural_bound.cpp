// Natural interval extension: every operation of the expression is replaced by that operation on sets (Moore
// 1966).

#include "base/error.h"
#include "enclosure/arithmetic_option.h"
#include "enclosure/bound_registry.h"
#include "enclosure/scoped_evaluator.h"
#include "polynomial/horner.h"

namespace gcslab {
namespace {

/// Evaluates equivalent forms of f and intersects their ranges.
template <class T>
class NaturalBound final : public RangeBound {
 public:
  NaturalBound(const std::vector<Expression>& forms, int variables, int bits)
      : forms_(forms.size()), evaluator_(forms, variables, bits) {}

  Interval over(const Box& box) override {
    const auto scope = evaluator_.open();
    const TapeEvaluator<T>& values = evaluator_.at(box);
    Interval result = NumberTraits<T>::enclosure(values.value(0));
    for (std::size_t i = 1; i < forms_; ++i) {
      result = intersection(result, NumberTraits<T>::enclosure(values.value(i)));
    }
    return result;
  }

 private:
  std::size_t forms_;
  ScopedEvaluator<T> evaluator_;
};

std::vector<Expression> forms_of(const BoundTarget& target, const std::string& form) {
  if (form == "as_written" || (form == "tightest" && !target.is_polynomial())) return {target.function()};
  try {
    if (form == "expanded") return {target.polynomial().to_expression(target.graph())};
    const Expression horner = horner_form(target.polynomial(), target.graph());
    if (form == "horner") return {horner};
    return {target.function(), horner};
  } catch (const NotApplicable& reason) {
    throw NotApplicable("in the form " + form + " " + reason.what());
  }
}

std::unique_ptr<RangeBound> make(const BoundTarget& target, const Options& options) {
  const std::vector<Expression> forms = forms_of(target, options.word("form"));
  return make_for_arithmetic(options, [&]<class T>(int bits) -> std::unique_ptr<RangeBound> {
    return std::make_unique<NaturalBound<T>>(forms, target.variables(), bits);
  });
}

}  // namespace

BoundVariant natural_bound() {
  return {"natural",
          "natural interval extension of the expression (Moore 1966)",
          "every function; the forms expanded and horner take polynomials",
          1,
          with_arithmetic_options(
              {choice_option("form", "what is evaluated; tightest intersects as_written and horner",
                             "as_written", {"as_written", "expanded", "horner", "tightest"})}),
          make};
}

}  // namespace gcslab
