#include "polynomial/upward_kernels.h"

#include <gtest/gtest.h>

#include "polynomial/bernstein.h"
#include "polynomial/power.h"
#include "support/random_polynomial.h"

namespace gcslab {
namespace {

/// A tensor with three variables; the middle one has the given length.
template <class Numbers>
Numbers small_integers(Random& random, const Exponents& degrees) {
  std::vector<Rational> values(coefficient_count(degrees));
  for (Rational& value : values) value = random.integer(-1000, 1000);
  return Numbers(degrees, values);
}

template <class FastTensor, class ExactTensor>
FastTensor fast(const ExactTensor& tensor) {
  std::vector<FastInterval> values;
  for (const Rational& value : tensor.coefficients())
    values.push_back(NumberTraits<FastInterval>::from_rational(value));
  return FastTensor(tensor.degrees(), values);
}

template <class FastTensor, class ExactTensor>
void expect_equal(const FastTensor& tensor, const ExactTensor& reference) {
  ASSERT_EQ(tensor.degrees(), reference.degrees());
  for (std::size_t i = 0; i < reference.coefficients().size(); ++i) {
    ASSERT_TRUE(is_singleton(tensor.coefficients()[i].interval())) << i;
    ASSERT_EQ(rational_from_double(tensor.coefficients()[i].upper()), reference.coefficients()[i]) << i;
  }
}

/// Dyadic coefficients with few bits are halved exactly, whatever the length and the way the columns share
/// vectors.
template <template <class> class TensorOf>
void halves_exactly(int longest) {
  Random random(1, "kernels");
  const NumberTraits<FastInterval>::Scope scope;
  for (int degree = 0; degree <= longest; ++degree) {
    const Exponents degrees{static_cast<int>(random.integer(0, 4)), degree,
                            static_cast<int>(random.integer(0, 4))};
    const auto reference = small_integers<TensorOf<Rational>>(random, degrees);
    const auto tensor = fast<TensorOf<FastInterval>>(reference);
    TensorOf<Rational> exact_left, exact_right;
    reference.halve(1, exact_left, exact_right);
    TensorOf<FastInterval> left, right;
    tensor.halve(1, left, right);
    expect_equal(left, exact_left);
    expect_equal(right, exact_right);
    TensorOf<FastInterval> in_place = tensor;
    in_place.halve(1, left, in_place);
    expect_equal(left, exact_left);
    expect_equal(in_place, exact_right);
    in_place = tensor;
    in_place.halve(1, in_place, right);
    expect_equal(in_place, exact_left);
    expect_equal(right, exact_right);
  }
}

TEST(UpwardKernels, BernsteinHalvesExactly) { halves_exactly<BernsteinTensor>(40); }
TEST(UpwardKernels, PowerHalvesExactly) { halves_exactly<PowerTensor>(40); }

TEST(UpwardKernels, LongColumnsAreHalvedSoundly) {
  Random random(1, "long columns");
  const NumberTraits<FastInterval>::Scope scope;
  const auto reference = small_integers<BernsteinTensor<Rational>>(random, {100, 1});
  BernsteinTensor<Rational> exact_left, exact_right;
  reference.halve(0, exact_left, exact_right);
  BernsteinTensor<FastInterval> left, right;
  fast<BernsteinTensor<FastInterval>>(reference).halve(0, left, right);
  for (std::size_t i = 0; i < left.coefficients().size(); ++i) {
    EXPECT_TRUE(encloses(left.coefficients()[i], exact_left.coefficients()[i]));
    EXPECT_TRUE(encloses(right.coefficients()[i], exact_right.coefficients()[i]));
  }
}

TEST(UpwardKernels, LargestDoublesStayBounded) {
  const NumberTraits<FastInterval>::Scope scope;
  const double huge = std::numeric_limits<double>::max();
  for (const double sign : {1.0, -1.0}) {
    for (const bool in_place : {false, true}) {
      BernsteinTensor<FastInterval> tensor({9}, std::vector<FastInterval>(10, FastInterval(sign * huge)));
      BernsteinTensor<FastInterval> left, other;
      BernsteinTensor<FastInterval>& right = in_place ? tensor : other;
      tensor.halve(0, left, right);
      EXPECT_EQ(left.range(), Interval(sign * huge));
      EXPECT_EQ(right.range(), Interval(sign * huge));
    }
  }
}

TEST(UpwardKernels, UnboundedCoefficientsStayOnTheirSide) {
  const NumberTraits<FastInterval>::Scope scope;
  const double infinity = std::numeric_limits<double>::infinity();
  BernsteinTensor<FastInterval> tensor({2, 0}, std::vector<FastInterval>(3, FastInterval(1.0, infinity)));
  BernsteinTensor<FastInterval> left, right;
  tensor.halve(0, left, right);
  EXPECT_EQ(left.range(), Interval(1, infinity));
  EXPECT_EQ(right.range(), Interval(1, infinity));
}

TEST(UpwardKernels, HullAndSumsOfEveryLength) {
  Random random(1, "sums");
  const NumberTraits<FastInterval>::Scope scope;
  for (std::size_t count = 1; count <= 40; ++count) {
    std::vector<FastInterval> values;
    Interval expected_hull;
    double symmetric = 0, low = 0, high = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const auto lower = static_cast<double>(random.integer(-100, 100));
      const auto upper = lower + static_cast<double>(random.integer(0, 100));
      values.emplace_back(lower, upper);
      expected_hull = hull(expected_hull, Interval(lower, upper));
      const double size = magnitude(Interval(lower, upper));
      symmetric += size;
      low += i % 2 == 0 ? std::min(lower, 0.0) : -size;
      high += i % 2 == 0 ? std::max(upper, 0.0) : size;
    }
    EXPECT_EQ(hull_upward(values.data(), count).interval(), expected_hull);
    EXPECT_EQ(symmetric_sum_upward(values.data(), count).interval(), Interval(-symmetric, symmetric));
    EXPECT_EQ(alternating_sum_upward(values.data(), count).interval(), Interval(low, high));
  }
  EXPECT_EQ(symmetric_sum_upward(nullptr, 0).interval(), Interval(0, 0));
}

}  // namespace
}  // namespace gcslab
