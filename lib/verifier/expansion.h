#pragma once

// The equations, and the functions of the inequalities after them, expanded about the midpoint m of a box, in
// z with x_i = m_i + r_i z_i, z in [-1, 1]^n.
//
// Promise: at every point of the box, the function of row k equals constant + sum of values[c] * column c,
// for some choice of numbers within the ranges. A polynomial is expanded into all monomials of its Taylor
// expansion at m, which is exact up to rounding; any other function, and a polynomial whose expansion has
// more than 20,000 terms, gets f(m) and its slopes over the box in the linear columns. Where such a function
// may be undefined the constant is unbounded. Midpoints and radii are those of lib/interval/interval.h, as
// doubles.
//
// Multiples of equations that are polynomials: the product by a monomial is expanded as a polynomial is. The
// quotient of an equation x_i g + c = 0, with a constant c, by x_i is g + c / x_i: g expanded as above, c /
// x_i by its slope. Where side i contains 0 its constant is unbounded.

#include <cstdint>
#include <map>
#include <vector>

#include "verifier/judged_system.h"

namespace gcslab::verifier {

/// A monomial of z: variables ascending, each with its power >= 1.
using Monomial = std::vector<std::pair<std::uint32_t, int>>;

struct ExpandedRow {
  Range constant;
  std::vector<std::uint32_t> columns;  ///< numbers of monomials, none twice
  std::vector<Range> values;
};

/// An equation times a monomial, or divided by one variable.
struct EquationMultiple {
  std::size_t equation;
  Monomial factor;
  bool is_quotient;
  auto operator<=>(const EquationMultiple&) const = default;  // NOLINT: a false alarm about nullptr
};

class Expansion {
 public:
  /// `system` must outlive it.
  explicit Expansion(JudgedSystem& system);

  std::size_t variables() const { return midpoints_.size(); }
  /// The first ones are the variables.
  const std::vector<Monomial>& columns() const { return columns_; }

  /// From here on, rows are about the midpoint of that bounded box.
  void expand(const Box& box);
  const Box& box() const { return box_; }
  const std::vector<double>& midpoints() const { return midpoints_; }
  const std::vector<double>& radii() const { return radii_; }
  /// The row of a function, computed when first asked for.
  const ExpandedRow& row(std::size_t number);
  /// Whether the equation is a polynomial, and one of that form for a quotient, of no more terms than may be.
  bool has_multiple(const EquationMultiple& multiple);
  /// The row of a multiple that there is.
  const ExpandedRow& row(const EquationMultiple& multiple);

 private:
  struct Term {
    Range coefficient;
    std::uint32_t product;  ///< of midpoints
  };
  struct Entry {
    std::uint32_t column;  ///< kConstant for the constant
    std::vector<Term> terms;
  };
  static constexpr std::uint32_t kConstant = ~std::uint32_t{0};
  struct MultipleRow {
    bool is_there = false;
    std::vector<Entry> entries;  ///< of the product, or of g
    Range constant;              ///< c
    bool is_made = false;
    ExpandedRow row;
  };

  MultipleRow planned(const EquationMultiple& multiple);
  void add_reciprocal(const MultipleRow& multiple, std::size_t variable, ExpandedRow& row) const;
  void compute_products();
  void plan(const PolynomialTerms& polynomial, std::vector<Entry>& entries);
  std::uint32_t column_of(const std::vector<int>& exponents);
  std::uint32_t product_of(const std::vector<int>& exponents);
  void compute_products(const std::vector<double>& numbers, std::vector<Range>& products) const;
  void expand_polynomial(const std::vector<Entry>& entries, ExpandedRow& row) const;
  void expand_by_mean_value(Program& program, ExpandedRow& row);
  JudgedFunction& function(std::size_t row);

  JudgedSystem* system_;
  std::vector<Monomial> columns_;
  std::map<Monomial, std::uint32_t> number_of_column_;
  std::vector<std::uint32_t> column_products_;  ///< of radii, one a column
  /// Products of variables: that of `first` times variable `second`. Number 0 is the empty product.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> products_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> number_of_product_;
  std::vector<std::vector<Entry>> entries_;  ///< one a row; empty where the mean value form is taken
  Box box_;
  std::vector<double> midpoints_, radii_;
  std::vector<Range> midpoint_products_, radius_products_;
  std::vector<ExpandedRow> rows_;
  std::vector<bool> has_row_;
  std::map<EquationMultiple, MultipleRow> multiples_;  ///< those that were asked for
};

}  // namespace gcslab::verifier
