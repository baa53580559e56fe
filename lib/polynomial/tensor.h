#pragma once

// Dense arrays of polynomial coefficients of any dimension.
//
// A tensor of degrees (d_1, ..., d_n) holds (d_1 + 1) ... (d_n + 1) coefficients in row-major order: the
// index of the last variable runs fastest. What basis they belong to is said by the class derived from it
// (bernstein.h, power.h). A tensor without variables holds one number.

#include <cstddef>
#include <utility>
#include <vector>

#include "polynomial/polynomial.h"

namespace gcslab {

/// More coefficients than this are refused: (d_1 + 1) ... (d_n + 1) grows too fast to be tried blindly.
inline constexpr std::size_t kMaximumCoefficients = std::size_t{1} << 24;

/// The number of coefficients. Throws NotApplicable above kMaximumCoefficients.
std::size_t coefficient_count(const Exponents& degrees);

/// A tensor as seen along one variable: `blocks` blocks of `count` rows of `row` consecutive elements;
/// neighbouring rows belong to neighbouring indices of the variable.
struct AxisShape {
  std::size_t blocks;
  std::size_t count;
  std::size_t row;
};

AxisShape axis_shape(const Exponents& degrees, int variable);

/// Steps to the next index in row-major order; false after the last one, when `index` is all 0 again.
bool next_index(Exponents& index, const Exponents& degrees);

template <class T>
class Tensor {
 public:
  Tensor() : coefficients_(1) {}
  Tensor(Exponents degrees, std::vector<T> coefficients)
      : degrees_(std::move(degrees)), coefficients_(std::move(coefficients)) {}

  int variables() const { return static_cast<int>(degrees_.size()); }
  const Exponents& degrees() const { return degrees_; }
  int degree(int variable) const { return degrees_[static_cast<std::size_t>(variable)]; }

  std::vector<T>& coefficients() { return coefficients_; }
  const std::vector<T>& coefficients() const { return coefficients_; }
  /// The coefficient with that index, one number a variable.
  const T& at(const Exponents& index) const { return coefficients_[offset(index)]; }

  AxisShape shape(int variable) const { return axis_shape(degrees_, variable); }

 protected:
  std::size_t offset(const Exponents& index) const {
    std::size_t place = 0;
    for (std::size_t i = 0; i < degrees_.size(); ++i) {
      place = place * static_cast<std::size_t>(degrees_[i] + 1) + static_cast<std::size_t>(index[i]);
    }
    return place;
  }
  /// Takes the shape of `other`; no allocation when it fits into what is there.
  void resize_like(const Tensor& other) {
    degrees_ = other.degrees_;
    coefficients_.resize(other.coefficients_.size());
  }

  Exponents degrees_;
  std::vector<T> coefficients_;
};

}  // namespace gcslab
