#pragma once

// The equations of a polynomial system in the tensor Bernstein basis of a box, and where a combination of
// them can vanish, seen along one variable.
//
// On x_i = u_i + (v_i - u_i) t_i, t in [0, 1]^n, a polynomial of degrees d is sum b_j B_j(t), where B_j >= 0
// sums to 1. The coefficient of x^m in degree d is the polar form of x^m at (u, .., u, v, .., v) with j times
// v: sum over k of C(j, k) C(d - j, m - k) / C(d, m) v^k u^(m - k) (Ramshaw 1989). Collected by layers along
// variable i, the polynomial lies between the two univariate polynomials of the least and of the largest
// coefficient of each layer; each lies in the convex hull of its points (j / d_i, b_j) (Sherbrooke and
// Patrikalakis 1993), on [0, 1] and on every part of it (Mourrain and Pavone 2009).

#include <vector>

#include "verifier/judged_system.h"

namespace gcslab::verifier {

class BernsteinForms {
 public:
  /// `system` must outlive it.
  explicit BernsteinForms(JudgedSystem& system);

  /// Whether every equation is a polynomial and all coefficients together are at most 2^20.
  bool applies() const { return applies_; }

  /// From here on, forms are about that bounded box. Only where it applies.
  void convert(const Box& box);

  /// Encloses the coordinates `variable` of the zeros of sum multipliers[k] f_k in the box: by the convex
  /// hull of the points, and, unless that lies in `claim`, by hulls of ever smaller parts.
  Range zeros(std::size_t variable, const std::vector<double>& multipliers, const Interval& claim) const;

 private:
  /// One univariate band: the range of each layer.
  using Layers = std::vector<Range>;

  std::vector<RangeBox> matrix_of(std::size_t variable) const;
  void transform(std::size_t variable, std::vector<Range>& tensor) const;
  Layers layers_along(std::size_t variable, const std::vector<double>& multipliers) const;
  Range on_side(std::size_t variable, const Range& t) const;

  JudgedSystem* system_;
  bool applies_ = true;
  std::vector<int> degrees_;                 ///< the largest of all equations, one a variable
  std::vector<std::size_t> strides_;         ///< of the exponents of each variable
  std::size_t size_ = 1;                     ///< coefficients of one equation
  std::vector<std::vector<Range>> tensors_;  ///< one an equation
  Box box_;
};

}  // namespace gcslab::verifier
