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

  /// Sets result[row], for each form, to its value at x.
  void values(std::span<const double> x, std::span<double> result) const;
  /// Adds to derivatives(row, column[i]), for each form and variable i, speed[i] times the derivative by it.
  void add_derivatives(std::span<const double> x, std::span<const double> speed,
                       std::span<const std::size_t> column, Matrix<double>& derivatives) const;

 private:
  /// Sums of terms, one after the other: each is read once, from left to right, into a register.
  class Sums {
   public:
    /// Ends with the terms that were added since the last one.
    void finish() {
      ends_.push_back({constant_, linear_.size(), products_.size(), cubics_.size()});
      constant_ = 0;
    }
    /// A term of the sum that is not finished: the product of at most three variables.
    void add(double coefficient, std::span<const std::uint32_t> factors);
    void scale(std::size_t sum, double factor);
    /// Calls take(number, value at x) for each sum.
    template <class Take>
    void evaluate(std::span<const double> x, const Take& take) const;

   private:
    struct Linear {
      std::uint32_t i;
      double coefficient;
    };
    struct Product {
      std::uint32_t i, j;
      double coefficient;
    };
    struct Cubic {
      std::uint32_t i, j, k;
      double coefficient;
    };
    struct End {
      double constant;
      std::size_t linear, products, cubics;
    };
    double constant_ = 0;
    std::vector<Linear> linear_;
    std::vector<Product> products_;
    std::vector<Cubic> cubics_;
    std::vector<End> ends_;
  };
  struct Derivative {
    std::size_t row, variable;
  };

  Sums forms_;
  std::vector<std::size_t> rows_;  ///< of the forms
  Sums slopes_;
  std::vector<Derivative> derivatives_;  ///< what the slopes are
};

}  // namespace gcslab
