#pragma once

// The simplex method in exact rationals over the midpoints of a model: the true optimum, from any starting
// basis.
//
// Every step factorises the constraints that hold the vertex anew (exact_factorisation.h): meant to finish or
// confirm what a rounded solver left, in a few steps. Bland's rule (1977) makes it end. A start that is
// feasible neither way first becomes optimal for an objective of its own, and then primal feasible by dual
// steps.

#include <span>
#include <vector>

#include "linear_program/exact_program.h"
#include "linear_program/lp_solution.h"

namespace gcslab {

struct ExactSolution {
  LpStatus status = LpStatus::failed;  ///< optimal or infeasible; iteration_limit
  Rational objective;
  std::vector<Rational> primal;         ///< one a column
  std::vector<Rational> multipliers;    ///< one a row; the ray when infeasible
  std::vector<Rational> reduced_costs;  ///< one a column
  LpBasis basis;
  long steps = 0;
};

class ExactSimplex {
 public:
  explicit ExactSimplex(const LpModel& model) : program_(model) {}

  /// min c.x from a basis; an empty or unfit one is completed by column bounds.
  ExactSolution minimise(std::span<const LinearTerm> objective, const LpBasis& start,
                         long step_limit = 1000000);

 private:
  struct Held {
    std::size_t constraint;
    int inward;  ///< 1 at the lower side, -1 at the upper one, 0 for an equation
  };
  enum class Outcome { done, infeasible, step_limit };

  void hold_basis(const LpBasis& basis);
  void complete();
  ExactFactorisation factorise() const;
  bool is_held(std::size_t constraint) const;
  int inward_for(std::size_t constraint, bool at_upper) const;
  const Rational& side(const Held& held) const;
  std::vector<Rational> dense_normal(std::size_t constraint) const;
  std::vector<Rational> point(const ExactFactorisation& factors) const;
  std::vector<Rational> own_objective() const;
  bool is_dual_feasible(const std::vector<Rational>& multipliers) const;
  Outcome solve(const std::vector<Rational>& cost);

  Outcome mend_violations(const std::vector<Rational>& cost);
  std::size_t first_violated(const std::vector<Rational>& point, int& direction) const;
  std::size_t slot_to_leave(const std::vector<Rational>& along, const std::vector<Rational>& multipliers,
                            int direction) const;
  Outcome walk_down(const std::vector<Rational>& cost);
  std::size_t first_improving(const std::vector<Rational>& multipliers) const;
  void step_along(const ExactFactorisation& factors, std::size_t slot);
  void write(const std::vector<Rational>& cost, ExactSolution& solution) const;
  void note_ray(std::size_t constraint, int direction, const std::vector<Rational>& along);

  ExactProgram program_;
  std::vector<Held> held_;
  std::vector<Rational> ray_;
  long steps_ = 0;
  long step_limit_ = 0;
};

}  // namespace gcslab
