#pragma once

// Our own simplex method, made for many objectives over one polytope with far more rows than columns.
//
// A vertex is held by as many constraints as there are columns; it keeps its edges as an explicit matrix
// (edge_matrix.h), so that the multipliers of a new objective x_j are read off, and a step costs one pass
// over the sparse rows and one rank-one update. A dual simplex for an objective that the starting vertex is
// optimal for by construction, with random multipliers, reaches a vertex or a proof that there is none; the
// primal simplex with steepest edges (Forrest, Goldfarb 1992) then starts from the best of the optima found
// before (vertex_pool.h). These polytopes are highly degenerate: the walk is on sides moved outward by about
// 1e-6 (Charnes 1952) with Harris's ratio test (1973), and each optimum is then computed from the true sides,
// by dual simplex steps where its vertex is not feasible there; the walk goes on from where it was.
//
// Answers are rounded: tolerance 1e-9 of feasibility in scaled rows. Multipliers are refined once against
// the rows. One thread; round to nearest.

#include <cstdint>
#include <span>
#include <vector>

#include "base/random.h"
#include "linear_program/lp_solution.h"
#include "linear_program/simplex_kernel.h"
#include "linear_program/simplex_program.h"
#include "linear_program/simplex_vertex.h"
#include "linear_program/vertex_pool.h"

namespace gcslab {

struct SimplexOptions {
  bool cold = false;             ///< starts every objective from a corner of the column box
  long iteration_limit = 20000;  ///< steps an objective may take
};

class Simplex {
 public:
  explicit Simplex(const SimplexOptions& options) : options_(options) {}

  /// A model of the structure before keeps the constraints that hold the vertex.
  void load(const LpModel& model);
  /// As LpBackend::minimise.
  void minimise(std::span<const LinearTerm> objective, LpSolution& solution);

 private:
  enum class Walk { done, infeasible, iteration_limit, inaccurate };

  static LpStatus status_of(Walk outcome);
  void start_over();
  Walk reach_feasibility();
  Walk solve_moved();
  Walk solve_true(LpSolution& solution);

  Walk walk_along_edges(const ConstraintSides& sides);
  Walk step_along_edge(std::size_t slot, const ConstraintSides& sides);
  std::size_t steepest_edge() const;

  simplex_kernel::Violation violation(const ConstraintSides& sides) const;
  Walk mend_violations(const ConstraintSides& sides);
  Walk mend(std::size_t constraint, const ConstraintSides& sides);
  std::size_t slot_to_leave(double direction) const;

  void set_multipliers();
  void set_random_multipliers();
  void exchange(std::size_t slot, std::size_t constraint, double inward, const ConstraintSides& sides);
  bool pivot_agrees(std::size_t slot, double rate) const;
  void note_ray(std::size_t constraint, double direction);

  void refine(std::span<const double> normal, std::vector<double>& slot_multipliers);
  void write_multipliers(std::span<const double> slot_multipliers, std::vector<double>& rows) const;
  void write_vertex(LpSolution& solution) const;
  void write_reduced_costs(std::vector<double>& reduced_costs) const;
  void write_basis(LpBasis& basis) const;

  SimplexOptions options_;
  SimplexProgram program_;
  SimplexVertex vertex_;
  SimplexVertex walk_;               ///< the vertex on moved sides while one on true sides is sought
  std::vector<double> walk_values_;  ///< its values there
  VertexPool pool_;
  bool feasible_ = false;
  bool infeasible_ = false;
  long iterations_ = 0;
  Random random_{1, "simplex multipliers"};
  std::vector<double> cost_;        ///< one a column
  std::vector<double> multiplier_;  ///< one a slot: the objective along the edges
  std::vector<double> walk_multiplier_;
  std::vector<double> along_;  ///< one a slot
  std::vector<double> edge_;
  std::vector<double> rate_;  ///< one a constraint
  std::vector<double> residual_;
  std::vector<double> ray_;  ///< one a row of the model
  LpBasis ray_basis_;        ///< where the ray was found
};

}  // namespace gcslab
