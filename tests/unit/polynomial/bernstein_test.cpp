#include "polynomial/bernstein.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "interval/arithmetic.h"
#include "interval/point_numbers.h"
#include "support/random_polynomial.h"

namespace gcslab {
namespace {

using Exact = BernsteinTensor<Rational>;
using Numbers = std::vector<Rational>;

Rational fraction(long numerator, long denominator) { return Rational(numerator) / Rational(denominator); }

Exact exact(const Polynomial& p, const RationalBox& box, const Exponents& degrees = {}) {
  return bernstein_from_polynomial<Rational>(p, box, degrees);
}

RationalBox unit_box(int variables) { return RationalBox(static_cast<std::size_t>(variables), {0, 1}); }

bool equal(const Exact& a, const Exact& b) {
  return a.degrees() == b.degrees() && a.coefficients() == b.coefficients();
}

/// x^3 + y^3 - 3xy.
Polynomial folium() {
  const Polynomial x = Polynomial::variable(2, 0);
  const Polynomial y = Polynomial::variable(2, 1);
  return pow(x, 3) + pow(y, 3) - Rational(3) * x * y;
}

TEST(Bernstein, CoefficientsOfTheFolium) {
  const Exact tensor = exact(folium(), unit_box(2));
  for (int i = 0; i <= 3; ++i) {
    for (int j = 0; j <= 3; ++j)
      EXPECT_EQ(tensor.at({i, j}), (i == 3) + (j == 3) - fraction(static_cast<long>(i) * j, 3));
  }
}

TEST(Bernstein, HalvesOfTheFolium) {  // de Casteljau by hand, column by column
  Exact left;
  Exact right;
  exact(folium(), unit_box(2)).halve(0, left, right);
  const auto q = [](std::initializer_list<long> twentyfourths) {
    Numbers result;
    for (const long n : twentyfourths) result.push_back(fraction(n, 24));
    return result;
  };
  EXPECT_EQ(left.coefficients(), q({0, 0, 0, 24, 0, -4, -8, 12, 0, -8, -16, 0, 3, -9, -21, -9}));
  EXPECT_EQ(right.coefficients(), q({3, -9, -21, -9, 6, -10, -26, -18, 12, -8, -28, -24, 24, 0, -24, -24}));
}

TEST(Bernstein, DegreeFourConversionMatrix) {  // column k: the coefficients of x^k
  const std::vector<Numbers> columns = {
      {1, 1, 1, 1, 1},
      {0, fraction(1, 4), fraction(1, 2), fraction(3, 4), 1},
      {0, 0, fraction(1, 6), fraction(1, 2), 1},
      {0, 0, 0, fraction(1, 4), 1},
      {0, 0, 0, 0, 1},
  };
  for (int k = 0; k <= 4; ++k) {
    const Polynomial power = pow(Polynomial::variable(1, 0), k);
    EXPECT_EQ(exact(power, unit_box(1), {4}).coefficients(), columns[static_cast<std::size_t>(k)]);
    EXPECT_EQ(bernstein_computed_in<Rational>(power, unit_box(1), {4}).coefficients(),
              columns[static_cast<std::size_t>(k)]);
  }
}

TEST(Bernstein, PartitionOfUnity) {
  const Exact one = exact(Polynomial::constant(3, 1), unit_box(3), {2, 3, 4});
  EXPECT_EQ(one.coefficients().size(), 60U);
  for (const Rational& b : one.coefficients()) EXPECT_EQ(b, 1);
}

class RandomBernstein : public testing::TestWithParam<int> {
 protected:
  /// Runs check(polynomial, box, tensor) on random polynomials in the test's number of variables.
  template <class Check>
  void for_random(const Check& check) {
    Random random(1, "bernstein");
    for (int i = 0; i < 40; ++i) {
      const Polynomial p = random_polynomial(random, GetParam(), GetParam() > 2 ? 3 : 6, 8);
      const RationalBox box = random_box(random, GetParam());
      check(random, p, box, exact(p, box));
    }
  }
  int random_variable(Random& random) { return static_cast<int>(random.integer(0, GetParam() - 1)); }
};

INSTANTIATE_TEST_SUITE_P(Dimensions, RandomBernstein, testing::Values(1, 2, 3, 4));

TEST_P(RandomBernstein, EvaluatesToThePolynomial) {
  for_random([&](Random& random, const Polynomial& p, const RationalBox& box, const Exact& tensor) {
    const Numbers t = random_unit_point(random, GetParam());
    EXPECT_EQ(tensor.evaluate(t), p.evaluate(point_in_box(box, t)));
  });
}

TEST_P(RandomBernstein, BothConversionsAgree) {
  for_random([&](Random&, const Polynomial& p, const RationalBox& box, const Exact& tensor) {
    EXPECT_TRUE(equal(bernstein_computed_in<Rational>(p, box), tensor));
  });
}

TEST_P(RandomBernstein, CornersAreValues) {
  for_random([&](Random&, const Polynomial& p, const RationalBox& box, const Exact& tensor) {
    for (std::size_t corner = 0; corner < std::size_t{1} << GetParam(); ++corner) {
      Numbers t;
      for (int i = 0; i < GetParam(); ++i) t.emplace_back((corner >> i) & 1U);
      EXPECT_EQ(tensor.corner(corner), p.evaluate(point_in_box(box, t)));
    }
  });
}

TEST_P(RandomBernstein, SplittingIsConversionOnTheParts) {
  for_random([&](Random& random, const Polynomial& p, const RationalBox& box, const Exact& tensor) {
    const int variable = random_variable(random);
    const auto axis = static_cast<std::size_t>(variable);
    const Rational t = fraction(random.integer(-3, 12), random.integer(1, 9));
    RationalBox left = box;
    RationalBox right = box;
    left[axis].upper = right[axis].lower = box[axis].lower + (box[axis].upper - box[axis].lower) * t;
    const auto parts = tensor.split(variable, t);
    EXPECT_TRUE(equal(parts.first, exact(p, left, tensor.degrees())));
    EXPECT_TRUE(equal(parts.second, exact(p, right, tensor.degrees())));
  });
}

TEST_P(RandomBernstein, HalvingIsSplittingAtOneHalf) {
  for_random([&](Random& random, const Polynomial&, const RationalBox&, const Exact& tensor) {
    const int variable = random_variable(random);
    const auto parts = tensor.split(variable, Rational(1, 2));
    Exact left;
    Exact right;
    tensor.halve(variable, left, right);
    EXPECT_TRUE(equal(left, parts.first));
    EXPECT_TRUE(equal(right, parts.second));
    Exact in_place = tensor;
    in_place.halve(variable, in_place, right);
    EXPECT_TRUE(equal(in_place, parts.first));
    in_place = tensor;
    in_place.halve(variable, left, in_place);
    EXPECT_TRUE(equal(in_place, parts.second));
  });
}

TEST_P(RandomBernstein, ElevationIsConversionAtTheHigherDegree) {
  for_random([&](Random& random, const Polynomial& p, const RationalBox& box, const Exact& tensor) {
    const int variable = random_variable(random);
    Exponents degrees = tensor.degrees();
    degrees[static_cast<std::size_t>(variable)] += 3;
    EXPECT_TRUE(equal(tensor.elevated(variable, 3), exact(p, box, degrees)));
    EXPECT_TRUE(equal(tensor.elevated(variable, 0), tensor));
  });
}

TEST_P(RandomBernstein, DerivativeIsTheDerivative) {
  for_random([&](Random& random, const Polynomial& p, const RationalBox& box, const Exact& tensor) {
    const int variable = random_variable(random);
    const auto axis = static_cast<std::size_t>(variable);
    const Numbers t = random_unit_point(random, GetParam());
    const Rational chain = box[axis].upper - box[axis].lower;
    EXPECT_EQ(tensor.derivative(variable).evaluate(t),
              chain * p.derivative(variable).evaluate(point_in_box(box, t)));
  });
}

TEST_P(RandomBernstein, FacesAreRestrictions) {
  for_random([&](Random& random, const Polynomial&, const RationalBox&, const Exact& tensor) {
    const int variable = random_variable(random);
    Numbers t = random_unit_point(random, GetParam());
    for (const Side side : {Side::lower, Side::upper}) {
      t[static_cast<std::size_t>(variable)] = side == Side::lower ? 0 : 1;
      Numbers rest = t;
      rest.erase(rest.begin() + variable);
      EXPECT_EQ(tensor.face(variable, side).evaluate(rest), tensor.evaluate(t));
    }
  });
}

TEST_P(RandomBernstein, RangeContainsValuesAndShrinksWithDegree) {
  for_random([&](Random& random, const Polynomial&, const RationalBox&, const Exact& tensor) {
    const Rational value = tensor.evaluate(random_unit_point(random, GetParam()));
    const auto [least, largest] = extreme_coefficients(tensor);
    EXPECT_LE(least, value);
    EXPECT_LE(value, largest);
    EXPECT_TRUE(encloses(tensor.range(), value));
    EXPECT_TRUE(subset(tensor.elevated(0, 2).range(), tensor.range()));
  });
}

TEST(Bernstein, SharpExactlyWhenCornersAttainBothBounds) {
  const Polynomial x = Polynomial::variable(1, 0);
  EXPECT_TRUE(exact(pow(x, 5), unit_box(1)).sharp());
  EXPECT_FALSE(exact(x - pow(x, 2), unit_box(1)).sharp());
  EXPECT_TRUE(exact(Polynomial(1), unit_box(1)).sharp());
}

TEST(Bernstein, SmallCases) {
  const Exact zero = exact(Polynomial(2), unit_box(2));
  EXPECT_EQ(zero.coefficients(), Numbers{0});
  EXPECT_EQ(zero.derivative(1).coefficients(), Numbers{0});
  const Exact number = exact(Polynomial::constant(0, 3), {});
  EXPECT_EQ(number.coefficients(), Numbers{3});
  EXPECT_EQ(number.evaluate({}), 3);
  EXPECT_EQ(number.corner(0), 3);
  const Exact at_point = exact(folium(), {{2, 2}, {fraction(1, 3), fraction(1, 3)}});
  for (const Rational& b : at_point.coefficients()) EXPECT_EQ(b, 8 + fraction(1, 27) - 2);
}

TEST(Bernstein, RefusesUnboundedBoxesAndHugeTensors) {
  EXPECT_THROW(rational_box({{0, 1}, Interval::entire()}), NotApplicable);
  EXPECT_THROW(rational_box({Interval::empty()}), NotApplicable);
  EXPECT_THROW(coefficient_count({99999, 99999, 99999}), NotApplicable);
  EXPECT_EQ(coefficient_count({}), 1U);
}

TEST(Bernstein, PointTypesFollowTheExactCoefficients) {
  Random random(1, "point types");
  const Polynomial p = random_polynomial(random, 2, 5, 10);
  const RationalBox box{{-1, 2}, {fraction(1, 3), 4}};
  const Exact reference = exact(p, box);
  const auto in_double = bernstein_computed_in<double>(p, box);
  const auto in_float = bernstein_computed_in<float>(p, box);
  const double scale = magnitude(reference.range());
  for (std::size_t i = 0; i < reference.coefficients().size(); ++i) {
    const double value = reference.coefficients()[i].get_d();
    EXPECT_NEAR(in_double.coefficients()[i], value, 1e-10 * scale);
    EXPECT_NEAR(in_float.coefficients()[i], value, 1e-2 * scale);
  }
}

}  // namespace
}  // namespace gcslab
