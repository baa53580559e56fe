#pragma once

// A linear combination of the rows of an expansion, solved for one variable.

#include <optional>
#include <span>
#include <vector>

#include "box_solver/expansion.h"
#include "interval/reverse_operations.h"
#include "interval/scaled.h"

namespace gcslab {

/// The sum multipliers[k] f_k as an expansion in dense columns, and its solution for a variable.
template <class T>
class CombinedRow {
 public:
  explicit CombinedRow(const ExpansionPlan& plan);

  /// Sums the rows of the expansion. Multipliers are finite; those that are 0 leave their row out.
  void combine(const Expansion<T>& expansion, std::span<const double> multipliers);

  /// Encloses {z_i : z in the box `z`, the combination is 0 at z}. The expansion's bound_columns was last
  /// called with a box that contains `z`.
  T solve(std::size_t variable, std::span<const T> z, const Expansion<T>& expansion) const;
  /// The same, for a combination in which the square of z_i dominates.
  T solve_square(std::size_t variable, std::span<const T> z, const Expansion<T>& expansion) const;
  /// The variable whose linear coefficient is largest.
  std::size_t dominant_variable() const;
  /// The column of z_i^2, if there is one.
  std::optional<std::size_t> square_column(std::size_t variable) const;

 private:
  /// A column of degree >= 2, as `solve` takes it.
  struct Mixed {
    std::uint32_t column;
    std::uint32_t first, second;  ///< the variables of z_first z_second
  };

  /// The combination as rest + a z_i + q z_i^2, where rest has no z_i.
  struct Solvable {
    T rest;
    T a;
    const T* q;  ///< null: none
  };
  Solvable gathered(std::size_t variable, std::span<const T> z, const Expansion<T>& expansion) const;
  T range_without_one(std::size_t column, std::span<const T> z, std::size_t variable) const;

  const ExpansionPlan* plan_;
  std::vector<std::uint32_t> square_columns_;  ///< of each variable; kNone without one
  std::vector<Mixed> products_;                ///< z_i z_j, i < j
  std::vector<std::uint32_t> higher_;          ///< every other column of degree >= 2
  T zero_;
  T constant_;
  std::vector<T> values_;
  static constexpr std::uint32_t kNone = ~std::uint32_t{0};
};

}  // namespace gcslab
