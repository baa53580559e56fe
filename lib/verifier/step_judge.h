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
#include "verifier/lifted_terms.h"
#include "verifier/polytope_sum.h"

namespace gcslab::verifier {

/// The box about whose midpoint expansions are, with a number that tells it from others; 0: there is none.
struct ExpansionBox {
  std::uint64_t number = 0;
  Box box;
  Box terms;  ///< sides that contain the terms of the system there; empty: expansions know nothing of terms
};

class StepJudge {
 public:
  /// `system` must outlive it.
  explicit StepJudge(JudgedSystem& system);

  LiftedTerms& terms() { return terms_; }

  /// Propagation through an equation or inequality. `claim` is what is hoped for: a propagation on a larger
  /// box that was done before is used where it suffices.
  Range propagate(bool is_equation, std::size_t function, std::size_t variable, const Box& box,
                  const Interval& claim);
  /// To be called whenever the box may have grown since the last propagation.
  void forget_propagation() { propagated_ = nullptr; }

  ExpansionBox expansion_about(const Box& box, Box terms = {});
  /// What an expansion is of: the lifted system where sides of terms are given.
  JudgedSystem& expanded_system(const ExpansionBox& expansion);
  /// The box lies in the one of the expansion.
  Range expansion_row(const ExpansionBox& expansion, std::size_t variable, const EquationSum& sum,
                      const Box& box);
  Range square_row(const ExpansionBox& expansion, std::size_t variable, const EquationSum& sum,
                   const Box& box);
  bool has_multiple(const EquationMultiple& multiple) { return expansion_.has_multiple(multiple); }
  /// Multipliers of the expanded system, of products that are nowhere negative and of strips bound the
  /// variable, or show that there is no root: then the range is empty.
  Range polytope(const ExpansionBox& expansion, std::size_t variable, const PolytopeSum& sum, const Box& box);
  Range mean_value_row(const ExpansionBox& expansion, std::size_t variable,
                       const std::vector<double>& multipliers, const Box& box);
  /// Refuses, in words, where the equations have no Bernstein forms: then the text is not empty.
  std::string bernstein_refusal() const;
  Range bernstein_row(const ExpansionBox& expansion, std::size_t variable,
                      const std::vector<double>& multipliers, const Interval& claim, const Box& box);

 private:
  struct KeptRow {
    std::uint64_t expansion = 0;
    EquationSum sum;
    CombinedRow row;
  };

  CombinedRow& combined(const ExpansionBox& expansion, std::size_t variable, const EquationSum& sum,
                        const Box& box);
  static Range unscaled(const Expansion& about, std::size_t variable, const Range& z, const Box& box);
  Range propagated(std::size_t variable, const Box& box) const;
  void expand(const ExpansionBox& expansion);
  Expansion& expand_lifted(const ExpansionBox& expansion);
  void scale(std::uint64_t expansion, const Box& box);
  void compute_slopes(const ExpansionBox& expansion);

  JudgedSystem* system_;
  std::uint64_t last_expansion_ = 0;

  Program* propagated_ = nullptr;  ///< the program whose propagation is kept
  bool propagated_to_nothing_ = false;

  Expansion expansion_;
  std::uint64_t expanded_ = 0;  ///< number of the box that expansion_ is about
  std::vector<KeptRow> rows_;   ///< one a variable
  LiftedTerms terms_;
  std::optional<Expansion> lifted_expansion_;
  std::uint64_t lifted_expanded_ = 0;
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
