#pragma once

// Polynomials on the unit box in the tensor Bernstein basis, over any number type.
//
//   p(t) = sum_i b_i B_{i_1}^{d_1}(t_1) ... B_{i_n}^{d_n}(t_n),  B_i^d(t) = binomial(d, i) t^i (1 - t)^(d -
//   i).
//
// t in [0, 1]^n is relative to the box of the conversion: x = u + (v - u) t. Over a set-valued type the
// coefficients enclose the exact ones, and every operation keeps that promise; a NumberTraits<T>::Scope must
// be alive.
//
// Range: the B_i are nonnegative with sum 1, so p([0, 1]^n) lies in [min b, max b]; corner coefficients are
// values of p, so a bound attained at a corner is attained by p (Cargo and Shisha 1966).
// Subdivision: de Casteljau (1959). Conversion: x^k = sum_i binomial(i, k) / binomial(d, k) B_i^d.
//
// Compiled for the number types listed at the end of bernstein.cpp; another type is one line there.

#include <span>
#include <vector>

#include "polynomial/exact_conversion.h"
#include "polynomial/polynomial.h"
#include "polynomial/rational_box.h"
#include "polynomial/tensor.h"

namespace gcslab {

/// An end of an interval.
enum class Side { lower, upper };

template <class T>
class BernsteinTensor : public Tensor<T> {
 public:
  using Tensor<T>::Tensor;
  explicit BernsteinTensor(Tensor<T> tensor) : Tensor<T>(std::move(tensor)) {}

  /// The coefficients on the two halves of the variable's unit interval, by de Casteljau at 1/2. Allocates
  /// nothing when `left` and `right` are large enough; one of them may be this tensor.
  void halve(int variable, BernsteinTensor& left, BernsteinTensor& right) const;
  /// The coefficients on [0, t] and [t, 1] of the variable; t may be any number, but only 0 <= t <= 1 is
  /// stable.
  std::pair<BernsteinTensor, BernsteinTensor> split(int variable, const Rational& t) const;
  /// The same polynomial with the degree in a variable raised.
  BernsteinTensor elevated(int variable, int by) const;
  /// The partial derivative with respect to t (not x: that is 1 / (v - u) times it).
  BernsteinTensor derivative(int variable) const;
  /// The restriction to t_variable = 0 or 1, in one variable less.
  BernsteinTensor face(int variable, Side side) const;
  /// The value at a point of t, by de Casteljau.
  T evaluate(const std::vector<Rational>& point) const;
  /// The value at a corner of the unit box: variable j is 1 when bit j of `corner` is set, else 0.
  const T& corner(std::size_t corner) const;

  /// An enclosure of the values on the unit box: the hull of the coefficients.
  Interval range() const;
  /// True when both ends of `range` belong to corner coefficients, so that it is the exact range up to the
  /// width of these coefficients.
  bool sharp() const;

 private:
  Interval corner_hull() const;
};

/// Converts exactly and rounds once: each coefficient is the best that T can do.
template <class T>
BernsteinTensor<T> bernstein_from_polynomial(const Polynomial& polynomial, const RationalBox& box,
                                             const Exponents& degrees = {});

/// Converts polynomials to Bernstein form on one box after another, in the arithmetic of T, by the matrices
/// of the classical formula. What does not depend on the box is computed once. A set-valued T encloses the
/// exact coefficients, about as tightly as the terms of the polynomial can be summed at the lower corner of
/// the box.
template <class T>
class BernsteinConverter {
 public:
  /// `degrees` are at least those of each polynomial.
  BernsteinConverter(std::span<const Polynomial> polynomials, const Exponents& degrees);

  /// One tensor a polynomial, on the box of the points start + t width, t in [0, 1]^n.
  std::vector<BernsteinTensor<T>> convert(std::span<const T> starts, std::span<const T> widths) const;

 private:
  std::vector<std::vector<T>> matrix(std::size_t variable, const T& start, const T& width) const;

  Exponents degrees_;
  std::vector<Tensor<T>> power_tensors_;
  /// One a variable: binomial(k, j) binomial(i, j) / binomial(d, j) for i, k <= d, j <= min(i, k), in order.
  std::vector<std::vector<T>> factors_;
};

/// Converts in the arithmetic of T, by the matrices of the classical formula: how fast its errors grow with
/// the degree is what the conditioning study measures. Over a set-valued type it is rigorous all the same.
template <class T>
BernsteinTensor<T> bernstein_computed_in(const Polynomial& polynomial, const RationalBox& box,
                                         const Exponents& degrees = {});

/// The least and the largest coefficient, for types that are ordered.
template <class T>
std::pair<T, T> extreme_coefficients(const BernsteinTensor<T>& tensor);

}  // namespace gcslab
