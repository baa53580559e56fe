#pragma once

// A polynomial in several variables along a straight segment: a polynomial in one variable.
//
//   g(t) = f(from + t (to - from)) = sum_i b_i B_i^d(t),  t in [0, 1],  d the total degree of f.
//
// With s = 1 - t each coordinate is the form from s + to t, so that every monomial of f is a product of forms
// in (s, t); those of lower degree are multiplied by powers of s + t = 1. The coefficients of s^(d-i) t^i are
// binomial(d, i) b_i.

#include <span>
#include <vector>

#include "polynomial/polynomial.h"

namespace gcslab {

template <class T>
class SegmentRestriction {
 public:
  /// A NumberTraits<T>::Scope must be alive here and in all calls.
  explicit SegmentRestriction(const Polynomial& polynomial);

  int degree() const { return degree_; }
  /// The Bernstein coefficients along the segment, enclosed when T is set-valued.
  std::vector<T> bernstein_coefficients(std::span<const T> from, std::span<const T> to) const;

 private:
  using Form = std::vector<T>;  ///< coefficients of s^(m-i) t^i, by ascending i
  struct Term {
    Exponents exponents;
    T coefficient;
  };

  static Form product(const Form& a, const Form& b);
  Form monomial(const Term& term, const std::vector<std::vector<Form>>& powers) const;

  int degree_;
  Exponents degrees_;
  std::vector<std::vector<Term>> terms_;  ///< by total degree
  std::vector<T> binomials_;              ///< (d, i)
};

}  // namespace gcslab
