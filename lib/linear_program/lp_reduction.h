#pragma once

// The reduction of a box by its polytope: the least and largest value of each unknown over a linear program,
// or the proof that the program has no point (Tahari 2011, section 5; "optimisation-based bound tightening").
//
// Promise (safety `dual` and `exact`): every feasible point of the model, with interval data understood as in
// lp_model.h, lies within the bounds returned; `infeasible` is said only when there is none. What a solver
// says is never believed: bounds are recomputed from its multipliers with outward rounding (safe_bound.h).
// `tolerance` and `unprotected` are baselines that lose solutions.
//
// Few of the 2n programs need to be solved. An incumbent, an earlier optimal point, that touches a bound
// shows that this bound cannot improve (Baharev, Achterberg, Rev 2009, AIChE J. 55:1695); the next goal is
// the one nearest to the current point (Gleixner, Berthold, Mueller, Weltge 2017, "Three enhancements for
// optimization-based bound tightening", J. Global Optim. 67:731, sections 4.1 and 4.2). Skipping is always
// sound.

#include <span>
#include <vector>

#include "interval/rational.h"
#include "linear_program/lp_backend.h"
#include "linear_program/lp_model.h"
#include "linear_program/safe_bound.h"

namespace gcslab {

enum class LpSafety {
  dual,        ///< rigorous bounds from rounded multipliers
  exact,       ///< rigorous bounds from the exact multipliers of the midpoints: the true optimum on thin data
  tolerance,   ///< baseline: the solver's answer, widened by a tolerance
  unprotected  ///< baseline: the solver's answer
};

enum class BoundSide { lower, upper };

/// One question: how far can this bound of a column be moved inward?
struct LpGoal {
  int column;
  BoundSide side;
};

struct LpReductionOptions {
  LpSafety safety = LpSafety::dual;
  double tolerance = 1e-9;  ///< of LpSafety::tolerance
  /// Goals that cannot move their bound by more than this share of the column's width are skipped.
  double negligible_gain = 1e-9;
  bool nearest_first = true;  ///< else in the order given
  /// Stops after so many programs in a row that moved no bound by more than negligible_gain; 0: never.
  int fruitless_limit = 0;
  bool keep_certificates = false;
};

struct RowMultiplier {
  int row;
  double multiplier;
};

/// What proves one bound: safe_lower_bound of +-x_column from these multipliers gives it again.
struct BoundCertificate {
  LpGoal goal;
  double bound;
  std::vector<RowMultiplier> multipliers;
};

struct LpReductionResult {
  bool infeasible = false;
  /// One a row: the proof when infeasible by `dual`; by `exact` too, unless no doubles near the exact ray
  /// prove it.
  std::vector<double> ray;
  std::vector<Interval> bounds;  ///< one a column of the model; those without goal keep theirs
  std::vector<BoundCertificate> certificates;
  long solved = 0;      ///< programs solved
  long skipped = 0;     ///< goals answered by an incumbent
  long abandoned = 0;   ///< goals left by the fruitless limit, by failures, or by a verdict without proof
  long iterations = 0;  ///< of the solver
  long unproved = 0;    ///< verdicts "infeasible" that could not be proved, and were not used
};

class LpReduction {
 public:
  /// The backend must outlive the reduction, and belong to this thread.
  LpReduction(LpBackend& backend, const LpReductionOptions& options) : backend_(backend), options_(options) {}

  /// The answer lives until the next call.
  const LpReductionResult& reduce(const LpModel& model, std::span<const LpGoal> goals);

 private:
  void start(const LpModel& model, std::span<const LpGoal> goals);
  std::size_t next_goal() const;
  double distance(const LpGoal& goal, std::span<const double> point) const;
  void drop_goals_touched_by(std::span<const double> point);
  bool answer(const LpGoal& goal);
  double bound_from(const LpSolution& solution, const LinearTerm& objective);
  double exact_bound_from(const LpBasis& basis, const LinearTerm& objective);
  bool move_bound(const LpGoal& goal, double value);
  static std::size_t place_of(const LpGoal& goal);
  void keep_proof(const LpGoal& goal);
  bool is_rigorous() const;
  void settle_infeasible(const LpSolution& solution);
  void accept_ray(const std::vector<double>& ray);
  void accept_exact_ray(const std::vector<Rational>& ray);
  void settle_crossing(const LpGoal& goal);

  LpBackend& backend_;
  LpReductionOptions options_;
  const LpModel* model_ = nullptr;
  SafeBound safe_bound_;
  LpReductionResult result_;
  std::vector<LpGoal> goals_;                ///< not yet answered
  std::vector<double> multipliers_;          ///< of the last program
  std::vector<double> point_;                ///< the last incumbent
  std::vector<std::vector<double>> proofs_;  ///< of each bound that moved, its multipliers
};

/// The goals of a whole reduction: both sides of columns 0 ... count-1.
std::vector<LpGoal> both_sides(int count);

}  // namespace gcslab
