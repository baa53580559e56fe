#include "univariate/descartes.h"

#include <algorithm>
#include <limits>

#include "base/check.h"
#include "polynomial/bernstein.h"
#include "univariate/sign_variations.h"

namespace gcslab {
namespace {

using Coefficients = BernsteinTensor<FastInterval>;

/// An interval still to be searched.
struct Node {
  Rational lower;
  Rational upper;
  Coefficients coefficients;
  bool lower_is_done;  ///< the lower end is no root, or is listed
};

/// A constant of which nothing is known: it makes a node convert its polynomial exactly.
Coefficients unknown_coefficients() {
  return Coefficients(Tensor<FastInterval>({0}, {FastInterval(-1.0, 1.0)}));
}

/// An e such that the largest coefficient is about 2^e.
long exponent_of(const std::vector<Rational>& numbers) {
  long exponent = std::numeric_limits<long>::min();
  for (const Rational& x : numbers) {
    if (x == 0) continue;
    exponent = std::max(exponent, static_cast<long>(mpz_sizeinbase(x.get_num_mpz_t(), 2)) -
                                      static_cast<long>(mpz_sizeinbase(x.get_den_mpz_t(), 2)));
  }
  return exponent;
}

/// x / 2^exponent.
Rational shifted(Rational x, long exponent) {
  if (exponent < 0) mpq_mul_2exp(x.get_mpq_t(), x.get_mpq_t(), static_cast<mp_bitcnt_t>(-exponent));
  if (exponent > 0) mpq_div_2exp(x.get_mpq_t(), x.get_mpq_t(), static_cast<mp_bitcnt_t>(exponent));
  return x;
}

/// Enclosures of coefficients, not all 0, scaled so that none overflows.
Coefficients scaled_enclosures(const Tensor<Rational>& exact) {
  const long exponent = exponent_of(exact.coefficients());
  std::vector<FastInterval> numbers;
  for (const Rational& x : exact.coefficients())
    numbers.push_back(NumberTraits<FastInterval>::from_rational(shifted(x, exponent)));
  return Coefficients(Tensor<FastInterval>(exact.degrees(), std::move(numbers)));
}

SignVariations exact_variations(const std::vector<Rational>& numbers) {
  std::vector<FastInterval> signs;
  for (const Rational& x : numbers) signs.emplace_back(static_cast<double>(sgn(x)));
  return sign_variations(signs);
}

class Isolation {
 public:
  explicit Isolation(const IntegerPolynomial& polynomial) : polynomial_(polynomial.to_polynomial()) {}

  RootIsolation run(const RationalInterval& where, const std::stop_token& stop) {
    const NumberTraits<FastInterval>::Scope scope;
    if (where.lower < where.upper) open_.push_back({where.lower, where.upper, unknown_coefficients(), false});
    while (!open_.empty() && !stop.stop_requested()) {
      Node node = std::move(open_.back());
      open_.pop_back();
      search(std::move(node));
    }
    for (const Node& node : open_) found_.unsearched.push_back({node.lower, node.upper});
    if (open_.empty() && polynomial_.evaluate({&where.upper, 1}) == 0) add_point(where.upper);
    return std::move(found_);
  }

 private:
  void add_point(const Rational& point) { found_.roots.push_back({point, point}); }

  void search(Node node) {
    ++found_.counts.intervals;
    const std::vector<FastInterval>& numbers = node.coefficients.coefficients();
    const SignVariations variations = sign_variations(numbers);
    node.lower_is_done = node.lower_is_done || numbers[0].lower() > 0 || numbers[0].upper() < 0;
    const bool is_settled = node.lower_is_done && settle(node, variations);
    if (is_settled || (variations.least < 2 && settle(node, convert(node)))) return;
    halve(node);
  }

  /// Whether the sign variations tell how many roots the open interval contains; one is listed.
  bool settle(const Node& node, const SignVariations& variations) {
    if (variations.most == 0) return true;
    if (variations.least != 1 || variations.most != 1) return false;
    found_.roots.push_back({node.lower, node.upper});
    return true;
  }

  /// Exact coefficients in place of those that halvings have blurred, and their variations.
  SignVariations convert(Node& node) {
    ++found_.counts.exact_conversions;
    const Tensor<Rational> exact = exact_bernstein_coefficients(polynomial_, {{node.lower, node.upper}});
    if (!node.lower_is_done && exact.coefficients()[0] == 0) add_point(node.lower);
    node.lower_is_done = true;
    node.coefficients = scaled_enclosures(exact);
    return exact_variations(exact.coefficients());
  }

  /// The left half is searched first.
  void halve(const Node& node) {
    ++found_.counts.halvings;
    const Rational middle = (node.lower + node.upper) / 2;
    Node left{node.lower, middle, {}, node.lower_is_done};
    Node right{middle, node.upper, {}, false};
    node.coefficients.halve(0, left.coefficients, right.coefficients);
    open_.push_back(std::move(right));
    open_.push_back(std::move(left));
  }

  Polynomial polynomial_;
  std::vector<Node> open_;  ///< the last one is the leftmost
  RootIsolation found_;
};

/// a / b rounded up; b > 0.
long ceiling(long a, long b) { return a > 0 ? (a + b - 1) / b : -(-a / b); }

}  // namespace

RootIsolation isolate_square_free(const IntegerPolynomial& polynomial, const RationalInterval& where,
                                  const std::stop_token& stop) {
  GCSLAB_CHECK(!polynomial.is_zero() && where.lower <= where.upper);
  return Isolation(polynomial).run(where, stop);
}

Rational root_bound(const IntegerPolynomial& polynomial) {
  GCSLAB_CHECK(polynomial.degree() >= 1);
  const auto& c = polynomial.coefficients();
  const std::size_t d = c.size() - 1;
  const auto bits = [&](std::size_t k) { return static_cast<long>(mpz_sizeinbase(c[k].get_mpz_t(), 2)); };
  long exponent = std::numeric_limits<long>::min();
  for (std::size_t k = 0; k < d; ++k) {
    if (c[k] != 0) exponent = std::max(exponent, ceiling(bits(k) - bits(d) + 1, static_cast<long>(d - k)));
  }
  if (exponent == std::numeric_limits<long>::min()) return 1;
  return shifted(Rational(1), -(exponent + 1));
}

}  // namespace gcslab
