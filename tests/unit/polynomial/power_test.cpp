#include "polynomial/power.h"

#include <gtest/gtest.h>

#include "interval/arithmetic.h"
#include "interval/point_numbers.h"
#include "support/random_polynomial.h"

namespace gcslab {
namespace {

using Exact = PowerTensor<Rational>;

template <class T>
Interval range_of(const Polynomial& p, const RationalBox& box, TaubinVariant variant) {
  const typename NumberTraits<T>::Scope scope;
  return taubin_range(power_from_polynomial<T>(p, box), variant);
}

TEST(PowerTensor, RangeOfXTimesOneMinusX) {
  const Polynomial x = Polynomial::variable(1, 0);
  const Polynomial p = x - pow(x, 2);
  const RationalBox box{{0, 1}};
  EXPECT_EQ(range_of<FastInterval>(p, box, TaubinVariant::plain), Interval(0, 0.5));
  EXPECT_EQ(range_of<FastInterval>(p, box, TaubinVariant::even), Interval(0, 0.25));
  EXPECT_EQ(range_of<MpfrInterval>(p, box, TaubinVariant::plain), Interval(0, 0.5));
  EXPECT_EQ(range_of<MpfrInterval>(p, box, TaubinVariant::even), Interval(0, 0.25));
}

TEST(PowerTensor, FastRangeAgreesWithOtherArithmetics) {
  Random random(1, "taubin");
  for (int i = 0; i < 300; ++i) {
    const int variables = static_cast<int>(random.integer(0, 3));
    const Polynomial p =
        random_polynomial(random, variables, 5, 9, [&] { return Rational(random.integer(-50, 50)); });
    RationalBox box;  // dyadic, so that every arithmetic is exact
    for (int j = 0; j < variables; ++j) box.push_back({random.integer(-5, 0), random.integer(0, 5)});
    for (const TaubinVariant variant : {TaubinVariant::plain, TaubinVariant::even}) {
      const Interval fast = range_of<FastInterval>(p, box, variant);
      EXPECT_EQ(fast, range_of<BoostInterval>(p, box, variant));
      EXPECT_EQ(fast, range_of<MpfrInterval>(p, box, variant));
    }
  }
}

TEST(PowerTensor, ValuesAreThoseOfThePolynomial) {
  Random random(1, "power values");
  for (int i = 0; i < 200; ++i) {
    const int variables = static_cast<int>(random.integer(1, 4));
    const Polynomial p = random_polynomial(random, variables, 4, 8);
    const RationalBox box = random_box(random, variables);
    std::vector<Rational> t = random_unit_point(random, variables);
    const Rational value = p.evaluate(point_in_box(box, t));
    for (Rational& z : t) z = 2 * z - 1;
    EXPECT_EQ(power_from_polynomial<Rational>(p, box).evaluate(t), value);
    for (const TaubinVariant variant : {TaubinVariant::plain, TaubinVariant::even}) {
      EXPECT_TRUE(encloses(range_of<FastInterval>(p, box, variant), value));
    }
    const double plain_width = width(range_of<FastInterval>(p, box, TaubinVariant::plain));
    EXPECT_LE(width(range_of<FastInterval>(p, box, TaubinVariant::even)), plain_width * (1 + 1e-14));
  }
}

TEST(PowerTensor, HalvingIsConversionOnTheHalves) {
  Random random(1, "power halves");
  for (int i = 0; i < 100; ++i) {
    const int variables = static_cast<int>(random.integer(1, 4));
    const Polynomial p = random_polynomial(random, variables, 4, 8);
    const RationalBox box = random_box(random, variables);
    const auto axis = static_cast<std::size_t>(random.integer(0, variables - 1));
    RationalBox lower = box;
    RationalBox upper = box;
    lower[axis].upper = upper[axis].lower = (box[axis].lower + box[axis].upper) / 2;
    const Exact tensor = power_from_polynomial<Rational>(p, box);
    Exact left;
    Exact right = tensor;
    right.halve(static_cast<int>(axis), left, right);
    EXPECT_EQ(left.coefficients(), power_from_polynomial<Rational>(p, lower).coefficients());
    EXPECT_EQ(right.coefficients(), power_from_polynomial<Rational>(p, upper).coefficients());
  }
}

}  // namespace
}  // namespace gcslab
