#include "polynomial/exact_conversion.h"

#include "base/check.h"
#include "base/error.h"

namespace gcslab {
namespace {

mpz_class common_multiple(const mpz_class& a, const mpz_class& b) {
  mpz_class result;
  mpz_lcm(result.get_mpz_t(), a.get_mpz_t(), b.get_mpz_t());
  return result;
}

mpz_class power(const mpz_class& base, std::size_t exponent) {
  mpz_class result;
  mpz_pow_ui(result.get_mpz_t(), base.get_mpz_t(), exponent);
  return result;
}

mpz_class binomial(std::size_t n, std::size_t k) {
  mpz_class result;
  mpz_bin_uiui(result.get_mpz_t(), n, k);
  return result;
}

/// Integers over a common denominator.
struct Fraction {
  std::vector<mpz_class> numerators;
  mpz_class denominator = 1;
};

Fraction dense_coefficients(const Polynomial& polynomial, const Exponents& degrees) {
  Fraction result;
  result.numerators.resize(coefficient_count(degrees));
  for (const auto& [exponents, coefficient] : polynomial.terms()) {
    result.denominator = common_multiple(result.denominator, coefficient.get_den());
  }
  for (const auto& [exponents, coefficient] : polynomial.terms()) {
    std::size_t place = 0;
    for (std::size_t i = 0; i < degrees.size(); ++i) {
      GCSLAB_CHECK(exponents[i] <= degrees[i]);
      place = place * static_cast<std::size_t>(degrees[i] + 1) + static_cast<std::size_t>(exponents[i]);
    }
    result.numerators[place] = coefficient.get_num() * (result.denominator / coefficient.get_den());
  }
  return result;
}

/// The numbers along one variable at one place of the others.
class Fibre {
 public:
  Fibre(mpz_class* first, std::size_t step, std::size_t count) : first_(first), step_(step), count_(count) {}
  std::size_t degree() const { return count_ - 1; }
  mpz_class& operator[](std::size_t k) const { return first_[k * step_]; }

 private:
  mpz_class* first_;
  std::size_t step_;
  std::size_t count_;
};

template <class Work>
void for_each_fibre(Fraction& values, const AxisShape& shape, const Work& work) {
  for (std::size_t b = 0; b < shape.blocks; ++b) {
    for (std::size_t i = 0; i < shape.row; ++i) {
      work(Fibre(&values.numerators[b * shape.count * shape.row + i], shape.row, shape.count));
    }
  }
}

/// An affine substitution x = (shift + scale y) / denominator.
struct Substitution {
  mpz_class shift;
  mpz_class scale;
  mpz_class denominator;
};

/// Coefficients in x to those in y, times denominator^d.
void substitute(const Fibre& c, const Substitution& x) {
  const std::size_t d = c.degree();
  mpz_class factor = 1;
  for (std::size_t k = d; k-- > 0;) c[k] *= (factor *= x.denominator);
  if (x.shift != 0) {
    for (std::size_t i = 0; i < d; ++i) {
      for (std::size_t k = d; k-- > i;) c[k] += x.shift * c[k + 1];
    }
  }
  factor = 1;
  for (std::size_t k = 1; k <= d; ++k) c[k] *= (factor *= x.scale);
}

/// Power coefficients c_k to binomial(d, i) times the Bernstein coefficients: sum c_k t^k (s + t)^(d-k) in
/// t^i s^(d-i).
void to_scaled_bernstein(const Fibre& c) {
  const std::size_t d = c.degree();
  for (std::size_t i = 0; i < d; ++i) {
    for (std::size_t k = 1; k <= d - i; ++k) c[k] += c[k - 1];
  }
}

/// Numerators and denominators of the ends of an interval over their common denominator.
Substitution from_unit_interval(const RationalInterval& x) {
  const mpz_class denominator = common_multiple(x.lower.get_den(), x.upper.get_den());
  const mpz_class lower = x.lower.get_num() * (denominator / x.lower.get_den());
  const mpz_class upper = x.upper.get_num() * (denominator / x.upper.get_den());
  return {lower, upper - lower, denominator};
}

Substitution from_symmetric_interval(const RationalInterval& x) {
  const Substitution unit = from_unit_interval(x);
  return {2 * unit.shift + unit.scale, unit.scale, 2 * unit.denominator};
}

void substitute_axis(Fraction& values, const AxisShape& shape, const Substitution& x) {
  for_each_fibre(values, shape, [&](const Fibre& fibre) { substitute(fibre, x); });
  values.denominator *= power(x.denominator, shape.count - 1);
}

/// The product of the binomials (d_j, i_j).
mpz_class binomials(const Exponents& degrees, const Exponents& index) {
  mpz_class result = 1;
  for (std::size_t i = 0; i < degrees.size(); ++i) {
    result *= binomial(static_cast<std::size_t>(degrees[i]), static_cast<std::size_t>(index[i]));
  }
  return result;
}

void check_sizes(const Polynomial& polynomial, const RationalBox& box, const Exponents& degrees) {
  const auto variables = static_cast<std::size_t>(polynomial.variables());
  GCSLAB_CHECK(box.size() == variables && degrees.size() == variables);
}

Rational quotient(const mpz_class& numerator, const mpz_class& denominator) {
  Rational result(numerator, denominator);
  result.canonicalize();
  return result;
}

}  // namespace

RationalBox rational_box(const Box& box) {
  RationalBox result;
  for (const Interval& x : box) {
    if (!is_bounded(x)) throw NotApplicable("the box is empty or unbounded");
    result.push_back({rational_from_double(x.lower), rational_from_double(x.upper)});
  }
  return result;
}

Tensor<Rational> exact_bernstein_coefficients(const Polynomial& polynomial, const RationalBox& box,
                                              Exponents degrees) {
  if (degrees.empty()) degrees = polynomial.degrees();
  check_sizes(polynomial, box, degrees);
  Fraction values = dense_coefficients(polynomial, degrees);
  for (std::size_t i = 0; i < box.size(); ++i) {
    const AxisShape shape = axis_shape(degrees, static_cast<int>(i));
    substitute_axis(values, shape, from_unit_interval(box[i]));
    for_each_fibre(values, shape, to_scaled_bernstein);
  }
  std::vector<Rational> coefficients;
  coefficients.reserve(values.numerators.size());
  Exponents index(degrees.size(), 0);
  for (const mpz_class& numerator : values.numerators) {
    coefficients.push_back(quotient(numerator, values.denominator * binomials(degrees, index)));
    next_index(index, degrees);
  }
  return {std::move(degrees), std::move(coefficients)};
}

Tensor<Rational> exact_power_coefficients(const Polynomial& polynomial, const RationalBox& box) {
  Exponents degrees = polynomial.degrees();
  check_sizes(polynomial, box, degrees);
  Fraction values = dense_coefficients(polynomial, degrees);
  for (std::size_t i = 0; i < box.size(); ++i) {
    substitute_axis(values, axis_shape(degrees, static_cast<int>(i)), from_symmetric_interval(box[i]));
  }
  std::vector<Rational> coefficients;
  coefficients.reserve(values.numerators.size());
  for (const mpz_class& numerator : values.numerators) {
    coefficients.push_back(quotient(numerator, values.denominator));
  }
  return {std::move(degrees), std::move(coefficients)};
}

}  // namespace gcslab
