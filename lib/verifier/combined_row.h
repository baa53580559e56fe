#pragma once

// A linear combination of the rows of an expansion, solved for one variable.

#include <utility>
#include <vector>

#include "verifier/expansion.h"

namespace gcslab::verifier {

/// The sum of multipliers[k] times equation k, and of multiples of equations times their multipliers.
struct EquationSum {
  std::vector<double> multipliers;
  std::vector<std::pair<EquationMultiple, double>> multiples{};
  bool operator==(const EquationSum&) const = default;
};

class CombinedRow {
 public:
  /// Every multiple is one that the expansion has.
  void combine(Expansion& expansion, const EquationSum& sum);

  /// Encloses {z_i : z in the box `z`, the combination is 0 at z}.
  Range solve(const Expansion& expansion, std::size_t variable, const RangeBox& z) const;
  /// The same by way of z_i^2.
  Range solve_square(const Expansion& expansion, std::size_t variable, const RangeBox& z) const;

 private:
  /// The combination as rest + slope z_i + square z_i^2, where rest has no z_i.
  struct Parts {
    Range rest, slope, square;
  };
  Parts parts(const Expansion& expansion, std::size_t variable, const RangeBox& z) const;
  void add_row(const ExpandedRow& row, double multiplier);
  void add_powers(Parts& parts, std::size_t variable, const RangeBox& z) const;
  void add_mixed(Parts& parts, const Monomial& monomial, const Range& value, std::size_t variable,
                 const RangeBox& z) const;

  Range constant_;
  std::vector<Range> values_;         ///< one a column
  std::vector<Range> squares_;        ///< coefficients of z_j^2
  std::vector<std::uint32_t> mixed_;  ///< columns of degree >= 2 that occur, squares left out
};

}  // namespace gcslab::verifier
