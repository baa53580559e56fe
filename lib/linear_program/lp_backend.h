#pragma once

// One interface for linear programming solvers: several objectives over one polytope, again and again.
//
// A backend is made, used and destroyed by one thread, and computes in round to nearest: both are checked at
// every call. Its answers are suggestions (lp_solution.h).

#include <span>
#include <thread>

#include "linear_program/lp_model.h"
#include "linear_program/lp_solution.h"

namespace gcslab {

class LpBackend {
 public:
  LpBackend() = default;
  virtual ~LpBackend() = default;
  LpBackend(const LpBackend&) = delete;
  LpBackend& operator=(const LpBackend&) = delete;

  /// Takes over the midpoints of a model; the model may change or vanish afterwards. A model of the same
  /// structure as the one before starts from the last basis, unless the backend was told to start cold.
  void load(const LpModel& model);

  /// min c.x over the loaded model, c being the midpoints of the terms, whose columns are different. The
  /// answer lives until the next call.
  const LpSolution& minimise(std::span<const LinearTerm> objective);

 protected:
  virtual void load_model(const LpModel& model) = 0;
  virtual void solve(std::span<const LinearTerm> objective, LpSolution& solution) = 0;

 private:
  void check_thread_and_rounding() const;

  std::thread::id owner_ = std::this_thread::get_id();
  int columns_ = -1;
  LpSolution solution_;
};

/// The value sum_i (y_i > 0 ? y_i L_i : y_i U_i) + min over the column box of (c - A^T y).x, in rounded
/// arithmetic: what multipliers y claim to bound. Multipliers of the wrong sign for an infinite side count as
/// 0.
double unsafe_bound(const LpModel& model, std::span<const LinearTerm> objective,
                    std::span<const double> multipliers);

/// The row that the column box misses most, as a ray; empty when it meets every row. For solvers that
/// see such a row before they start and give no reason.
std::vector<double> single_row_ray(const LpModel& model);

/// The multipliers, or their negatives if those claim more; an empty ray stays so. For solvers whose rays
/// have no settled sign.
void orient_ray(const LpModel& model, std::vector<double>& ray);

}  // namespace gcslab
