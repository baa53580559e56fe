#pragma once

// The Bernstein polytope of a box as a linear program (Tahari 2011, section 5; a reformulation-linearisation
// in the sense of Sherali and Adams 1990).
//
// One LP column for each monomial of the expansion of the system about the box (expansion.h), in the scaled
// variables z of [-1, 1]^n; monomials that occur in inequalities alone get one when they are few, or when the
// equations do not determine the variables. Rows: each expanded function; products of bound factors 1 +- z^a,
// as far as their monomials occur: for every product column z^a z^b of two others the four (1 +- z^a)
// (1 +- z^b) >= 0, for every square (1 +- z^a)^2 >= 0, or products of more factors (BoundProducts); the
// complements (z_i +- z_j)^2 >= 0; and the strips around graphs t = phi(x) of two variables. Coefficients are
// single numbers: what an interval coefficient is wider than that, and monomials without column, are in the
// sides of the row.
//
// Promise: every solution of the system in the box stands for a feasible point of the model.

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "box_solver/expansion.h"
#include "box_solver/term_ranges.h"
#include "interval/fast_interval.h"
#include "linear_program/lp_model.h"

namespace gcslab {

/// Which products of bound factors 1 +- z^a are rows, for monomials of degree 3 and more; those of degree 2
/// have all.
enum class BoundProducts {
  pairs,    ///< of two columns, as after quadratisation by a new variable for each column
  factors,  ///< of one factor for each variable, 1 +- z_i, with repetition (Sherali, Adams 1990)
  both
};

BoundProducts bound_products_from_name(const std::string& name);

struct SignedColumn {
  std::size_t column;
  int sign;
};

/// The product of all 1 + sign z^column >= 0; or with is_square the square of the sum of sign z^column >= 0.
struct ProductRow {
  std::vector<SignedColumn> factors;
  bool is_square = false;
};

/// A polynomial of z by its monomials, in the order in which they came.
class MonomialSum {
 public:
  using Term = std::pair<ScaledMonomial, double>;

  void add(const ScaledMonomial& monomial, double coefficient);
  const std::vector<Term>& terms() const { return terms_; }

 private:
  std::vector<Term> terms_;
};

class BernsteinPolytope {
 public:
  /// How many LP columns it takes.
  static std::size_t columns_for(const ExpansionPlan& plan);

  /// `plan` must outlive it.
  explicit BernsteinPolytope(const ExpansionPlan& plan, BoundProducts products = BoundProducts::factors,
                             std::span<const GraphColumns> graphs = {});

  /// Writes the functions of an expansion about the box that the z scale; only numbers change.
  void refill(const Expansion<FastInterval>& expansion);
  /// Writes the strips of a graph over that box.
  void refill_strips(std::size_t graph, const StripsOfGraph& strips, const Expansion<FastInterval>& about);

  const LpModel& model() const { return model_; }
  /// The factor by which a row of numbers that change was multiplied: function k, which is row k, or a strip.
  double scale(std::size_t row) const { return scales_[row]; }
  /// What the rows after the functions say, in their order.
  const std::vector<ProductRow>& products() const { return meanings_; }
  /// The rows after these: kStripsOfGraph for each graph.
  std::size_t first_strip() const { return plan_->rows() + meanings_.size(); }

 private:
  void add_columns();
  void add_functions();
  void refill_row(std::size_t k, const ExpansionRow<FastInterval>& row);
  void add_pairs();
  void add_pair(std::size_t first, std::size_t second);
  void add_bound_factors();
  void add_complements();
  void add_strips();
  void add_row(const ProductRow& row);
  MonomialSum product_of(const ProductRow& row) const;
  MonomialSum square_of(const ProductRow& row) const;
  std::optional<std::size_t> column_of(const ScaledMonomial& monomial) const;

  const ExpansionPlan* plan_;
  std::span<const ScaledMonomial> columns_;
  BoundProducts products_;
  LpModel model_;
  std::vector<ProductRow> meanings_;
  std::vector<GraphColumns> graphs_;
  std::vector<double> scales_;  ///< one a row
  std::vector<Interval> coefficients_;
};

}  // namespace gcslab
