#pragma once

// What a contractor did to a box and why, in a form that can be replayed without the contractor.
//
// Each step narrows one variable (or shows that the box has no root) by an argument that names all it rests
// on: the number of a function, or multipliers of the equations. A verifier repeats the argument in its own
// arithmetic and checks that what it gets lies in what is claimed.

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "interval/interval.h"

namespace gcslab {

enum class Argument : std::uint8_t {
  hull_of_equation,    ///< forward-backward propagation through equation `function` = 0
  hull_of_inequality,  ///< the same through inequality `function` <= 0
  expansion,           ///< from here on, expansions are about the midpoint of the box as it is now
  expansion_row,       ///< the expansion of sum multipliers[k] f_k, solved for the variable
  square_row,          ///< the expansion of sum multipliers[k] f_k, solved for the square of the variable
  polytope,        ///< equations, inequalities, products of bound factors and strips around graphs, summed
                   ///< with multipliers, bound the variable; the multipliers of inequalities follow those of
                   ///< equations and are <= 0. Where the last `expansion` names sides of terms, the functions
                   ///< are those of the lifted system (lifted_system.h)
  mean_value_row,  ///< the mean value form of sum multipliers[k] f_k over the box of the last `expansion`
  bernstein_row,   ///< the Bernstein form of the same over that box, seen along the variable
  cases,      ///< the steps up to `otherwise` are about the part where the variable is at most result.lower
  otherwise,  ///< those up to `join` are about the part where it is at least that
  join,       ///< the box is the hull of what is left of both parts; with nothing left it has no root
};

/// The word that proof logs use.
std::string_view name_of(Argument argument);

/// An equation times variables, with repetition; or, with is_quotient, an equation x_i g + c = 0 with a
/// constant c divided by its only variable x_i, for boxes whose side i has no 0 in it.
struct EquationMultiple {
  std::uint32_t equation;
  std::vector<std::uint32_t> variables;
  bool is_quotient;
};

struct MultipleMultiplier {
  EquationMultiple multiple;
  double multiplier;
};

/// A monomial of z in [-1, 1]^n as its variables with repetition, and a sign.
struct SignedMonomial {
  int sign;
  std::vector<std::uint32_t> variables;
};

/// The product of all 1 + sign z^variables, or with is_square the square of the sum of sign z^variables, with
/// its multiplier, which is not negative.
struct ProductMultiplier {
  std::vector<SignedMonomial> factors;
  bool is_square;
  double multiplier;
};

/// A strip lower <= t - slope x <= upper around the graph of term t over its argument x; a positive
/// multiplier is that of the lower side, a negative one that of the upper.
struct StripMultiplier {
  std::uint32_t term;
  double slope;
  double multiplier;
};

/// Cases nest. A part that a step shows to have no root has no further steps.
struct ProofStep {
  Argument argument;
  std::uint32_t function = 0;
  std::uint32_t variable = 0;
  Interval result{};  ///< of the variable; empty: the box has no root; `cases`: the border
  std::vector<double> multipliers{};
  std::vector<MultipleMultiplier> multiples{};  ///< of `expansion_row` and `square_row`: more of the sum
  std::vector<ProductMultiplier> products{};    ///< of `polytope`
  std::vector<StripMultiplier> strips{};        ///< of `polytope`
  Box terms{};  ///< of `expansion`: sides that contain the terms of the system
};

/// Collects the steps taken on one box, when somebody wants them.
class ProofTrace {
 public:
  explicit ProofTrace(bool wanted = false) : wanted_(wanted) {}

  bool wanted() const { return wanted_; }
  void add(ProofStep step) {
    if (wanted_) steps_.push_back(std::move(step));
  }
  void append(const ProofTrace& other) {
    if (wanted_) steps_.insert(steps_.end(), other.steps_.begin(), other.steps_.end());
  }
  const std::vector<ProofStep>& steps() const { return steps_; }
  void clear() { steps_.clear(); }

 private:
  bool wanted_;
  std::vector<ProofStep> steps_;
};

}  // namespace gcslab
