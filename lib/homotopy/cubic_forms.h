#pragma once

// Equations of degree at most 3, many at once, in doubles: most of a figure's equations are squared distances
// or volumes, and a list of coefficients is read faster than a tape.

#include <cstdint>
#include <span>
#include <vector>

#include "base/matrix.h"
#include "polynomial/polynomial.h"

namespace gcslab {

class CubicForms {
 public:
  /// Form number `row` of the results, of total degree at most 3; `variables` are the places of the
  /// polynomial's variables among all.
  void add(std::size_t row, const Polynomial& polynomial, std::span<const std::size_t> variables);
  /// Multiplies a form.
  void scale(std::size_t row, double factor);

  /// Adds to result[row], for each form, its value at x.
  void add_values(std::span<const double> x, std::span<double> result) const;
  /// The same, and to derivatives(row, column[i]), for each variable i, speed[i] times the derivative by it.
  void add_derivatives(std::span<const double> x, std::span<const double> speed,
                       std::span<const std::size_t> column, std::span<double> result,
                       Matrix<double>& derivatives) const;

 private:
  struct Cubic {
    std::uint32_t row, i, j, k;
    double coefficient;
  };
  struct Product {
    std::uint32_t row, i, j;
    double coefficient;
  };
  struct Linear {
    std::uint32_t row, i;
    double coefficient;
  };
  struct Constant {
    std::uint32_t row;
    double value;
  };
  std::vector<Cubic> cubics_;
  std::vector<Product> products_;
  std::vector<Linear> linear_;
  std::vector<Constant> constants_;
};

}  // namespace gcslab
