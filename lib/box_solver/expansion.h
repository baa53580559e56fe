#pragma once

// The functions of a system expanded about the midpoint of a box, in the scaled variables z of
// x_i = m_i + r_i z_i, z in [-1, 1]^n.
//
// Promise: wherever z stands for a point of the box at which all functions are defined, the function of row k
// equals constant(k) + sum over the columns c of row(k)[c] * monomial_c(z) for some choice of numbers within
// the interval coefficients. Functions are the left sides of the equations, and those of the inequalities
// f <= 0 where they are wanted. Columns 0 .. n-1 are the z_i themselves. A polynomial gets the columns of all
// monomials of its Taylor expansion, with coefficients as thin as rounding allows. Any other function, and a
// polynomial with too many monomials, gets its mean value form: f(m) and its slopes over the box, in the
// linear columns alone. A function that may be undefined in the box gets an empty row with an unbounded
// constant.
//
// Where they are wanted, further rows are multiples of equations by monomials (equation_multiples.h). Of a
// quotient g + c / x_i, g is expanded as above, c / x_i by its slope; the row is empty while 0 lies in side
// i.

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "box_solver/proof_step.h"
#include "certification/system_functions.h"

namespace gcslab {

/// One monomial of z: variables ascending, each with its power >= 1.
struct ScaledMonomial {
  struct Factor {
    std::uint32_t variable;
    int power;
    bool operator==(const Factor&) const = default;
    auto operator<=>(const Factor&) const = default;  // NOLINT: a false alarm about nullptr
  };
  std::vector<Factor> factors;

  bool operator==(const ScaledMonomial&) const = default;
  auto operator<=>(const ScaledMonomial&) const = default;  // NOLINT: a false alarm about nullptr
};

/// One row: values for some columns, ascending.
template <class T>
struct ExpansionRow {
  T constant;
  std::vector<std::uint32_t> columns;
  std::vector<T> values;
};

/// Which functions of a system an expansion has rows for.
enum class ExpandedFunctions {
  equations,
  equations_and_multiples,  ///< equations, then multiples of them
  constraints               ///< equations, then inequalities f <= 0
};

/// Which monomials and terms occur: found once for a system.
class ExpansionPlan {
 public:
  explicit ExpansionPlan(const SystemFunctions& functions,
                         ExpandedFunctions which = ExpandedFunctions::equations);

  const SystemFunctions& functions() const { return *functions_; }
  std::size_t rows() const { return rows_.size(); }
  /// Those that have rows, after the equations.
  const std::vector<EquationMultiple>& multiples() const { return multiples_; }
  bool is_inequality(std::size_t row) const {
    return row >= functions_->equations().size() + multiples_.size();
  }
  /// The function of a row; of a multiple: the equation.
  const SystemFunction& function(std::size_t row) const;
  const std::vector<ScaledMonomial>& columns() const { return columns_; }
  /// How many of the columns, the first ones, are the variables or occur in equations.
  std::size_t equation_columns() const { return equation_columns_; }
  /// Whether the function of that row is expanded as a polynomial.
  bool is_expanded(std::size_t row) const { return !rows_[row].entries.empty(); }

 private:
  template <class T>
  friend class Expansion;

  /// A product of powers: that of `parent` times variable^power.
  struct Product {
    std::uint32_t parent;
    std::uint32_t variable;
    int power;
    auto operator<=>(const Product&) const = default;  // NOLINT: a false alarm about nullptr
  };
  struct Term {
    std::uint32_t coefficient;
    std::uint32_t product;  ///< of midpoints
  };
  struct Entry {
    std::uint32_t column;   ///< kConstant for the constant
    std::uint32_t product;  ///< of radii
    std::uint32_t first_term;
    std::uint32_t end_term;
  };
  /// The part c / x_variable of a quotient.
  struct Reciprocal {
    std::uint32_t coefficient;
    std::uint32_t variable;
    std::size_t place;  ///< of the variable's column among those of the row
  };
  struct Row {
    std::vector<Entry> entries;
    std::optional<Reciprocal> reciprocal;
  };
  static constexpr std::uint32_t kConstant = ~std::uint32_t{0};

  /// Coefficients of the expansion as polynomials in the midpoints: monomials of z with the terms of each.
  struct Contribution {
    Rational coefficient;
    Exponents midpoint_powers;
  };
  using Entries = std::map<Exponents, std::vector<Contribution>>;

  static Entries expanded(const Polynomial& polynomial);
  void add_row(const SystemFunction& function);
  void add_multiple(const EquationMultiple& multiple);
  void add_entries(const Entries& entries);
  std::uint32_t column_of(const Exponents& exponents);
  std::uint32_t product_of(const Exponents& exponents);

  const SystemFunctions* functions_;
  std::vector<ScaledMonomial> columns_;
  std::size_t equation_columns_ = 0;
  std::vector<std::uint32_t> column_products_;  ///< one a column
  std::map<Product, std::uint32_t> product_numbers_;
  std::vector<Product> products_;  ///< after their parents; number 0 is the empty product
  std::vector<Rational> coefficients_;
  std::vector<Term> terms_;
  std::vector<Row> rows_;
  std::vector<EquationMultiple> multiples_;
};

template <class T>
class Expansion {
 public:
  /// A NumberTraits<T>::Scope must be alive from here to the last call. `plan` must outlive it.
  explicit Expansion(const ExpansionPlan& plan);

  /// Expands about the midpoint of a bounded box.
  void expand(const Box& box);

  /// Bounds the monomials of the columns over a part z of [-1, 1]^n, for column_range.
  void bound_columns(std::span<const T> z);
  const T& column_range(std::uint32_t column) const { return z_products_[plan_->column_products_[column]]; }

  std::span<const double> midpoints() const { return midpoints_; }
  std::span<const double> radii() const { return radii_; }
  const ExpansionRow<T>& row(std::size_t row) const { return rows_[row]; }
  const ExpansionPlan& plan() const { return *plan_; }

 private:
  void compute_products(std::span<const T> numbers, std::vector<T>& products) const;
  void expand_polynomial(std::size_t number);
  void add_reciprocal(std::size_t number);
  static void make_empty(ExpansionRow<T>& row);
  void expand_by_mean_value(std::size_t number);

  const ExpansionPlan* plan_;
  std::vector<T> coefficients_;
  std::vector<TapeEvaluator<T>> evaluators_;
  std::vector<double> midpoints_, radii_;
  std::vector<T> midpoint_products_, radius_products_, z_products_, box_, centre_, radius_box_;
  std::vector<ExpansionRow<T>> rows_;
};

}  // namespace gcslab
