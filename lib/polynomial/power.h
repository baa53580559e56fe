#pragma once

// Polynomials on [-1, 1]^n in powers of z, for Taubin's forms, over any number type.
//
//   p(z) = sum_k a_k z_1^(k_1) ... z_n^(k_n).
//
// z is relative to the box of the conversion: x = (u + v)/2 + (v - u)/2 z. Over a set-valued type the
// coefficients enclose the exact ones, and every operation keeps that promise; a NumberTraits<T>::Scope must
// be alive.
//
// Range (Taubin 1994): every monomial but the constant has values in [-1, 1], so
//   p([-1, 1]^n) lies in a_0 + [-1, 1] sum_{k != 0} |a_k|.
// Knowing that a monomial whose exponents are all even has values in [0, 1] is tighter: x(1 - x) on [0, 1] is
// 1/4 - z^2/4, with the range [0, 1/2] in the plain and the exact [0, 1/4] in the even variant.
//
// Compiled for the number types listed at the end of power.cpp; another type is one line there.

#include "polynomial/exact_conversion.h"
#include "polynomial/polynomial.h"
#include "polynomial/rational_box.h"
#include "polynomial/tensor.h"

namespace gcslab {

/// What the range of a power tensor knows of even powers.
enum class TaubinVariant { plain, even };

template <class T>
class PowerTensor : public Tensor<T> {
 public:
  using Tensor<T>::Tensor;
  explicit PowerTensor(Tensor<T> tensor) : Tensor<T>(std::move(tensor)) {}

  /// The coefficients of p on the lower and the upper half of the variable's interval, each again over [-1,
  /// 1]: z = (w - 1)/2 and z = (w + 1)/2. Allocates nothing when `left` and `right` are large enough; one of
  /// them may be this tensor.
  void halve(int variable, PowerTensor& left, PowerTensor& right) const;
  /// The value at a point of z, by Horner's scheme.
  T evaluate(const std::vector<Rational>& point) const;
};

/// Converts exactly and rounds once.
template <class T>
PowerTensor<T> power_from_polynomial(const Polynomial& polynomial, const RationalBox& box);

/// An enclosure of the values on [-1, 1]^n; set-valued types only.
template <class T>
Interval taubin_range(const PowerTensor<T>& tensor, TaubinVariant variant);

}  // namespace gcslab
