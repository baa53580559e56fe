#include "interval/affine_form.h"

#include <utility>

#include "interval/elementary.h"
#include "interval/fast_interval.h"

namespace gcslab {
namespace {

/// The affine sum of an operation on two sums, or none where an operand has none.
template <class Operation>
std::optional<AffineSum> combined(const AffineValue& x, const AffineValue& y, Operation operation) {
  if (!x.sum() || !y.sum()) return std::nullopt;
  return operation(*x.sum(), *y.sum());
}

/// The part of x's range where f is defined.
Interval cut_to_domain(const UnivariateFunction& f, const AffineValue& x) {
  return intersection(x.range(), f.domain());
}

std::optional<AffineSum> along(const std::optional<LinearEnclosure>& lines, const AffineValue& x) {
  if (!lines || !x.sum()) return std::nullopt;
  return AffineSum::linear(lines->slope, *x.sum(), lines->offset);
}

AffineValue with_range(const AffineValue& x, const Interval& range) {
  return {intersection(x.range(), range), x.sum()};
}

FastInterval fast(const AffineValue& x) { return FastInterval(x.range()); }

}  // namespace

AffineValue::AffineValue(const Interval& range, std::optional<AffineSum> sum) : range_(range) {
  if (is_empty(range_)) return;
  if (sum && sum->is_finite()) {
    range_ = intersection(range_, sum->range());
    if (!is_empty(range_)) sum_ = std::move(sum);
  } else if (is_bounded(range_)) {
    sum_ = AffineSum::variable(range_);
  }
}

namespace affine {

AffineValue constant(const Interval& x) {
  if (!is_bounded(x)) return {x, std::nullopt};
  return {x, AffineSum::constant(x)};
}

AffineValue variable(const Interval& x) { return {x, std::nullopt}; }

AffineValue negate(const AffineValue& x) {
  const Interval range = (-fast(x)).interval();
  if (!x.sum()) return {range, std::nullopt};
  return {range, -*x.sum()};
}

AffineValue add(const AffineValue& x, const AffineValue& y) {
  return {(fast(x) + fast(y)).interval(), combined(x, y, AffineSum::sum)};
}

AffineValue subtract(const AffineValue& x, const AffineValue& y) {
  return {(fast(x) - fast(y)).interval(), combined(x, y, AffineSum::difference)};
}

AffineValue multiply(const AffineValue& x, const AffineValue& y) {
  return {(fast(x) * fast(y)).interval(), combined(x, y, AffineSum::product)};
}

AffineValue divide(const AffineValue& x, const AffineValue& y, Approximation approximation) {
  const Interval range = (fast(x) / fast(y)).interval();
  if (!is_bounded(range) || contains(y.range(), 0)) return {range, std::nullopt};
  return with_range(multiply(x, power(y, -1, approximation)), range);
}

AffineValue power(const AffineValue& x, int n, Approximation approximation) {
  if (n == 0) return is_empty(x.range()) ? x : constant(1);
  if (n == 1) return x;
  const bool inflected = n > 1 && n % 2 != 0 && x.range().lower < 0 && x.range().upper > 0;
  if (!inflected) return apply(IntegerPower(n), x, approximation);
  return with_range(multiply(x, power(x, n - 1, approximation)), pow(fast(x), n).interval());
}

AffineValue power(const AffineValue& x, const Rational& exponent, Approximation approximation) {
  if (exponent.get_den() == 1 && exponent.get_num().fits_sint_p()) {
    return power(x, static_cast<int>(exponent.get_num().get_si()), approximation);
  }
  return apply(RationalPower(exponent), x, approximation);
}

AffineValue apply(const UnivariateFunction& f, const AffineValue& x, Approximation approximation) {
  const Interval argument = cut_to_domain(f, x);
  const Interval range = f.value(FastInterval(argument)).interval();
  if (is_singleton(argument)) return constant(range);
  if (!is_bounded(argument) || !is_bounded(range)) return {range, std::nullopt};
  return {range, along(enclose_linearly(f, argument, approximation), x)};
}

AffineValue absolute_value(const AffineValue& x, Approximation approximation) {
  const Interval range = abs(fast(x)).interval();
  if (!is_bounded(range)) return {range, std::nullopt};
  return {range, along(enclose_absolute_value(x.range(), approximation), x)};
}

AffineValue minimum(const AffineValue& x, const AffineValue& y, Approximation approximation) {
  const Interval range = min(fast(x), fast(y)).interval();
  if (!is_bounded(range)) return {range, std::nullopt};
  if (precedes(x.range(), y.range())) return x;
  if (precedes(y.range(), x.range())) return y;
  const AffineValue twice = subtract(add(x, y), absolute_value(subtract(x, y), approximation));
  return with_range(multiply(constant(0.5), twice), range);
}

AffineValue maximum(const AffineValue& x, const AffineValue& y, Approximation approximation) {
  return negate(minimum(negate(x), negate(y), approximation));
}

}  // namespace affine

template <Approximation approximation>
AffineForm<approximation> NumberTraits<AffineForm<approximation>>::from_rational(const Rational& value) {
  return Form(affine::constant(elementary::enclosing(value)));
}

template <Approximation approximation>
AffineForm<approximation> NumberTraits<AffineForm<approximation>>::pi() {
  return Form(affine::constant(elementary::pi()));
}

template struct NumberTraits<ChebyshevAffine>;
template struct NumberTraits<MinRangeAffine>;

}  // namespace gcslab
