#pragma once

// Repeats one argument of a proof on a box: what it leaves of a variable.
//
// Every function returns a range with this promise: each root of the system in the box has its coordinate
// `variable` in it. What is computed once for several steps (a propagation, an expansion, a combination) is
// kept until it no longer applies.

#include <cstdint>
#include <optional>
#include <vector>

#include "verifier/bernstein_forms.h"
#include "verifier/combined_row.h"
#include "verifier/expansion.h"
#include "verifier/judged_system.h"

namespace gcslab::verifier {

/// The box about whose midpoint expansions are, with a number that tells it from others; 0: there is none.
struct ExpansionBox {
  std::uint64_t number = 0;
  Box box;
};

/// multiplier times the product of all 1 + sign z^monomial, or with is_square times the square of the sum of
/// sign z^monomial; signs are -1 or 1, the multiplier is not negative.
struct PositiveProduct {
  std::vector<std::pair<int, Monomial>> factors;
  bool is_square;
  double multiplier;
};

class StepJudge {
 public:
  /// `system` must outlive it.
  explicit StepJudge(JudgedSystem& system);

  /// Propagation through an equation or inequality. `claim` is what is hoped for: a propagation on a larger
  /// box that was done before is used where it suffices.
  Range propagate(bool is_equation, std::size_t function, std::size_t variable, const Box& box,
                  const Interval& claim);
  /// To be called whenever the box may have grown since the last propagation.
  void forget_propagation() { propagated_ = nullptr; }

  ExpansionBox expansion_about(const Box& box);
  /// The box lies in the one of the expansion.
  Range expansion_row(const ExpansionBox& expansion, std::size_t variable,
                      const std::vector<double>& multipliers, const Box& box);
  Range square_row(const ExpansionBox& expansion, std::size_t variable,
                   const std::vector<double>& multipliers, const Box& box);
  /// Multipliers of equations and of products that are nowhere negative bound the variable, or show that
  /// there is no root: then the range is empty.
  Range polytope(const ExpansionBox& expansion, std::size_t variable, const std::vector<double>& multipliers,
                 const std::vector<PositiveProduct>& products, const Box& box);
  Range mean_value_row(const ExpansionBox& expansion, std::size_t variable,
                       const std::vector<double>& multipliers, const Box& box);
  /// Refuses, in words, where the equations have no Bernstein forms: then the text is not empty.
  std::string bernstein_refusal() const;
  Range bernstein_row(const ExpansionBox& expansion, std::size_t variable,
                      const std::vector<double>& multipliers, const Interval& claim, const Box& box);

 private:
  struct KeptRow {
    std::uint64_t expansion = 0;
    std::vector<double> multipliers;
    CombinedRow row;
  };

  CombinedRow& combined(const ExpansionBox& expansion, std::size_t variable,
                        const std::vector<double>& multipliers, const Box& box);
  Range unscaled(std::size_t variable, const Range& z, const Box& box) const;
  Range propagated(std::size_t variable, const Box& box) const;
  void expand(const ExpansionBox& expansion);
  void scale(std::uint64_t expansion, const Box& box);
  void compute_slopes(const ExpansionBox& expansion);

  JudgedSystem* system_;
  std::uint64_t last_expansion_ = 0;

  Program* propagated_ = nullptr;  ///< the program whose propagation is kept
  bool propagated_to_nothing_ = false;

  Expansion expansion_;
  std::uint64_t expanded_ = 0;  ///< number of the box that expansion_ is about
  std::vector<KeptRow> rows_;   ///< one a variable
  std::uint64_t scaled_ = 0;
  Box scaled_box_;
  RangeBox z_;

  BernsteinForms forms_;
  std::uint64_t converted_ = 0;  ///< number of the box that forms_ are about

  std::uint64_t sloped_ = 0;      ///< number of the box that slopes_ and values_ belong to
  std::vector<bool> is_defined_;  ///< equation k everywhere in that box
  RangeBox centre_, values_;
  RangeMatrix slopes_;
};

}  // namespace gcslab::verifier
