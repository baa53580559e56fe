// After any chain of subdivisions every coefficient encloses the exact one, in every rigorous arithmetic.
// A case is one coefficient compared, in each of the arithmetics.

#include <gtest/gtest.h>
#include <tuple>

#include "interval/arithmetic.h"
#include "polynomial/bernstein.h"
#include "polynomial/power.h"
#include "support/fuzz.h"
#include "support/random_polynomial.h"

namespace gcslab {
namespace {

/// Random polynomials whose coefficients are ordinary, as large as doubles get, as small, or all of that at
/// once.
Polynomial hostile_polynomial(Random& random, int variables) {
  static constexpr int kRanges[][2] = {{-20, 20}, {960, 1024}, {-1090, -1000}, {-1090, 1024}};
  const auto kind = random.below(6);
  const int terms = static_cast<int>(random.integer(0, 8));
  const int degree = variables == 1 ? 9 : variables == 2 ? 5 : 3;
  if (kind >= 4) return random_polynomial(random, variables, degree, terms);
  const int* range = kRanges[kind];
  return random_polynomial(random, variables, degree, terms,
                           [&] { return random_scaled(random, range[0], range[1]); });
}

constexpr std::size_t kDefaultCases = 200'000;

template <class T, template <class> class TensorOf>
void expect_enclosure(const TensorOf<T>& tensor, const TensorOf<Rational>& exact,
                      const std::string& context) {
  for (std::size_t i = 0; i < exact.coefficients().size(); ++i) {
    ASSERT_TRUE(encloses(tensor.coefficients()[i], exact.coefficients()[i]))
        << context << ", coefficient " << i << " is " << exact.coefficients()[i] << ", not in "
        << to_string(NumberTraits<T>::enclosure(tensor.coefficients()[i]));
  }
}

/// A tensor over T that is halved along with the exact one.
template <class T, template <class> class TensorOf>
struct Follower {
  using Scope = typename NumberTraits<T>::Scope;
  int bits;
  TensorOf<T> tensor, left, right;

  Follower(const TensorOf<Rational>& exact, int precision) : bits(precision) {
    const Scope scope(bits);
    std::vector<T> values;
    for (const Rational& value : exact.coefficients())
      values.push_back(NumberTraits<T>::from_rational(value));
    tensor = TensorOf<T>(exact.degrees(), std::move(values));
  }
  void halve(int variable, bool take_left, bool in_place) {
    const Scope scope(bits);
    if (!in_place) {
      tensor.halve(variable, left, right);
      std::swap(tensor, take_left ? left : right);
    } else if (take_left) {
      tensor.halve(variable, tensor, right);
    } else {
      tensor.halve(variable, left, tensor);
    }
  }
};

template <template <class> class TensorOf>
class Chain {
 public:
  Chain(const TensorOf<Rational>& exact, int bits)
      : exact_(exact), followers_{{exact, 53}, {exact, 53}, {exact, bits}} {}

  /// Halves in every arithmetic and compares; returns the number of coefficients compared.
  std::size_t halve(Random& random, const std::string& context) {
    const int variable = static_cast<int>(random.integer(0, exact_.variables() - 1));
    const bool take_left = random.below(2) == 0;
    const bool in_place = random.below(2) == 0;
    exact_.halve(variable, left_, right_);
    std::swap(exact_, take_left ? left_ : right_);
    std::apply(
        [&](auto&... follower) {
          (follower.halve(variable, take_left, in_place), ...);
          (expect_enclosure(follower.tensor, exact_, context), ...);
        },
        followers_);
    return exact_.coefficients().size();
  }

  const TensorOf<Rational>& exact() const { return exact_; }
  /// Calls check(range under T, name) for every arithmetic.
  template <class Check>
  void for_each(const Check& check) {
    std::apply([&](auto&... follower) { (check(follower), ...); }, followers_);
  }

 private:
  TensorOf<Rational> exact_, left_, right_;
  std::tuple<Follower<FastInterval, TensorOf>, Follower<BoostInterval, TensorOf>,
             Follower<MpfrInterval, TensorOf>>
      followers_;
};

template <template <class> class TensorOf, class Convert, class Check>
void halve_at_random(const std::string& component, const Convert& convert, const Check& check) {
  Random random(fuzz_seed(), component);
  const std::size_t cases = fuzz_cases(kDefaultCases);
  std::size_t compared = 0;
  for (int i = 0; compared < cases && !testing::Test::HasFatalFailure(); ++i) {
    const int variables = static_cast<int>(random.integer(1, 3));
    const Polynomial p = hostile_polynomial(random, variables);
    Chain<TensorOf> chain(convert(p, random_box(random, variables)),
                          static_cast<int>(random.integer(24, 200)));
    const auto length = random.integer(1, 5);
    for (std::int64_t step = 0; step < length; ++step) {
      compared += chain.halve(random, "polynomial " + std::to_string(i));
    }
    check(random, chain);
  }
}

BernsteinTensor<Rational> to_bernstein(const Polynomial& p, const RationalBox& box) {
  return bernstein_from_polynomial<Rational>(p, box);
}

PowerTensor<Rational> to_power(const Polynomial& p, const RationalBox& box) {
  return power_from_polynomial<Rational>(p, box);
}

TEST(PolynomialSoundness, BernsteinHalvingsAndRanges) {
  const auto check = [](Random& random, Chain<BernsteinTensor>& chain) {
    const std::vector<Rational> t = random_unit_point(random, chain.exact().variables());
    const Rational value = chain.exact().evaluate(t);
    chain.for_each([&](auto& follower) {
      const typename std::decay_t<decltype(follower)>::Scope scope(follower.bits);
      ASSERT_TRUE(encloses(follower.tensor.range(), value));
      ASSERT_TRUE(encloses(follower.tensor.evaluate(t), value));
    });
  };
  halve_at_random<BernsteinTensor>("bernstein halvings", to_bernstein, check);
}

TEST(PolynomialSoundness, PowerHalvingsAndTaubinRanges) {
  const auto check = [](Random& random, Chain<PowerTensor>& chain) {
    std::vector<Rational> z = random_unit_point(random, chain.exact().variables());
    for (Rational& coordinate : z) coordinate = 2 * coordinate - 1;
    const Rational value = chain.exact().evaluate(z);
    chain.for_each([&](auto& follower) {
      const typename std::decay_t<decltype(follower)>::Scope scope(follower.bits);
      ASSERT_TRUE(encloses(taubin_range(follower.tensor, TaubinVariant::plain), value));
      ASSERT_TRUE(encloses(taubin_range(follower.tensor, TaubinVariant::even), value));
    });
  };
  halve_at_random<PowerTensor>("power halvings", to_power, check);
}

/// The other operations on Bernstein tensors, each compared with the same operation on exact coefficients.
/// Returns the number of coefficients compared, of all operations together.
template <class T>
std::size_t check_operations(Random& random, const Polynomial& p, const RationalBox& box, int bits) {
  const typename NumberTraits<T>::Scope scope(bits);
  const auto exact = bernstein_from_polynomial<Rational>(p, box);
  const auto tensor = bernstein_computed_in<T>(p, box);
  expect_enclosure(tensor, exact, "conversion in T");
  const int variable = static_cast<int>(random.integer(0, p.variables() - 1));
  const Rational t = Rational(random.integer(-2, 9)) / Rational(random.integer(1, 7));
  const auto parts = tensor.split(variable, t);
  const auto exact_parts = exact.split(variable, t);
  expect_enclosure(parts.first, exact_parts.first, "left part");
  expect_enclosure(parts.second, exact_parts.second, "right part");
  expect_enclosure(tensor.derivative(variable), exact.derivative(variable), "derivative");
  expect_enclosure(tensor.elevated(variable, 2), exact.elevated(variable, 2), "elevation");
  expect_enclosure(tensor.face(variable, Side::upper), exact.face(variable, Side::upper), "face");
  return 5 *
         exact.coefficients().size();  // at least: conversion, two parts, elevation, and derivative with face
}

TEST(PolynomialSoundness, ConversionsSplitsDerivativesElevationsFaces) {
  Random random(fuzz_seed(), "bernstein operations");
  const std::size_t cases = fuzz_cases(kDefaultCases);
  std::size_t compared = 0;
  for (int i = 0; compared < cases && !HasFatalFailure(); ++i) {
    SCOPED_TRACE("polynomial " + std::to_string(i));
    const int variables = static_cast<int>(random.integer(1, 3));
    const Polynomial p = hostile_polynomial(random, variables);
    const RationalBox box = random_box(random, variables);
    compared += check_operations<FastInterval>(random, p, box, 53);
    check_operations<BoostInterval>(random, p, box, 53);
    check_operations<MpfrInterval>(random, p, box, static_cast<int>(random.integer(24, 200)));
  }
}

}  // namespace
}  // namespace gcslab
