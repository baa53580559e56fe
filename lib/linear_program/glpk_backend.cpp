// GLPK (Makhorin) behind the interface. Its environment and handles belong to the thread that makes them, and
// it aborts the program on an index out of range: LpModel and LpBackend have checked them all before.

#include <cmath>
#include <glpk.h>

#include "base/check.h"
#include "interval/rounding.h"
#include "linear_program/lp_registry.h"

namespace gcslab {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

/// GLPK's kind of bound for an interval.
int bound_kind(const Interval& bounds) {
  const bool below = std::isfinite(bounds.lower);
  const bool above = std::isfinite(bounds.upper);
  if (below && above) return bounds.lower == bounds.upper ? GLP_FX : GLP_DB;
  if (below) return GLP_LO;
  return above ? GLP_UP : GLP_FR;
}

LpActivity activity(int status, const Interval& bounds) {
  if (status == GLP_BS || status == GLP_NF) return LpActivity::free;
  if (status == GLP_NS) return LpActivity::at_lower;
  return status == GLP_NL && std::isfinite(bounds.lower) ? LpActivity::at_lower : LpActivity::at_upper;
}

/// GLPK keeps an environment a thread, which the last user of the thread frees.
class GlpkEnvironment {
 public:
  GlpkEnvironment() { ++users(); }
  ~GlpkEnvironment() {
    if (--users() == 0) glp_free_env();
  }
  GlpkEnvironment(const GlpkEnvironment&) = delete;
  GlpkEnvironment& operator=(const GlpkEnvironment&) = delete;

 private:
  static int& users() {
    thread_local int count = 0;
    return count;
  }
};

class GlpkBackend final : public LpBackend {
 public:
  explicit GlpkBackend(const Options& options) : cold_(starts_cold(options)) {
    glp_term_out(GLP_OFF);
    glp_init_smcp(&control_);
    control_.msg_lev = GLP_MSG_OFF;
    control_.it_lim = static_cast<int>(options.integer("iteration_limit"));
    problem_ = glp_create_prob();
    glp_set_obj_dir(problem_, GLP_MIN);
  }
  ~GlpkBackend() override { glp_delete_prob(problem_); }

 protected:
  void load_model(const LpModel& model) override {
    model_ = model;
    if (structure_ != model.structure()) make_structure();
    for (int column = 0; column < model.columns(); ++column) {
      const Interval& bounds = model.column(column);
      glp_set_col_bnds(problem_, column + 1, bound_kind(bounds), bounds.lower, bounds.upper);
    }
    for (int row = 0; row < model.rows(); ++row) set_row(row);
  }

  void solve(std::span<const LinearTerm> objective, LpSolution& solution) override {
    set_objective(objective);
    if (cold_) glp_std_basis(problem_);
    const int before = glp_get_it_cnt(problem_);
    int outcome = run(GLP_PRIMAL);
    if (outcome == GLP_EBADB || outcome == GLP_ESING || outcome == GLP_ECOND) {
      glp_std_basis(problem_);
      outcome = run(GLP_PRIMAL);
    }
    read(outcome, solution);
    solution.iterations = glp_get_it_cnt(problem_) - before;
  }

 private:
  void make_structure() {
    structure_ = model_.structure();
    glp_erase_prob(problem_);
    glp_set_obj_dir(problem_, GLP_MIN);
    if (model_.columns() > 0) glp_add_cols(problem_, model_.columns());
    if (model_.rows() > 0) glp_add_rows(problem_, model_.rows());
    glp_std_basis(problem_);
    objective_.clear();
  }

  void set_row(int row) {
    const Interval& sides = model_.sides(row);
    glp_set_row_bnds(problem_, row + 1, bound_kind(sides), sides.lower, sides.upper);
    const auto columns = model_.row_columns(row);
    indices_.assign(1, 0);
    values_.assign(1, 0.0);
    for (std::size_t k = 0; k < columns.size(); ++k) {
      indices_.push_back(columns[k] + 1);
      values_.push_back(model_.row_midpoints(row)[k]);
    }
    glp_set_mat_row(problem_, row + 1, static_cast<int>(columns.size()), indices_.data(), values_.data());
  }

  void set_objective(std::span<const LinearTerm> objective) {
    for (const LinearTerm& term : objective_) glp_set_obj_coef(problem_, term.column + 1, 0);
    objective_.assign(objective.begin(), objective.end());
    for (const LinearTerm& term : objective_) {
      glp_set_obj_coef(problem_, term.column + 1, midpoint(term.coefficient));
    }
  }

  int run(int method) {
    control_.meth = method;
    return glp_simplex(problem_, &control_);
  }

  void read(int outcome, LpSolution& solution) {
    if (outcome == GLP_EITLIM) {
      solution.status = LpStatus::iteration_limit;
      read_vertex(solution);
    } else if (outcome == 0 && glp_get_status(problem_) == GLP_OPT) {
      solution.status = LpStatus::optimal;
      read_vertex(solution);
    } else if (outcome == 0 && glp_get_prim_stat(problem_) == GLP_NOFEAS) {
      solution.status = LpStatus::infeasible;
      find_ray(solution.ray);
    }
  }

  void read_vertex(LpSolution& solution) const {
    const int columns = glp_get_num_cols(problem_);
    const int rows = glp_get_num_rows(problem_);
    solution.objective = glp_get_obj_val(problem_);
    solution.primal.resize(at(columns));
    solution.reduced_costs.resize(at(columns));
    solution.basis.columns.resize(at(columns));
    for (int column = 0; column < columns; ++column) {
      solution.primal[at(column)] = glp_get_col_prim(problem_, column + 1);
      solution.reduced_costs[at(column)] = glp_get_col_dual(problem_, column + 1);
      solution.basis.columns[at(column)] =
          activity(glp_get_col_stat(problem_, column + 1), model_.column(column));
    }
    solution.multipliers.resize(at(rows));
    solution.basis.rows.resize(at(rows));
    for (int row = 0; row < rows; ++row) {
      solution.multipliers[at(row)] = glp_get_row_dual(problem_, row + 1);
      solution.basis.rows[at(row)] = activity(glp_get_row_stat(problem_, row + 1), model_.sides(row));
    }
  }

  /// The dual simplex ends at a basic variable out of bounds that no other can mend: its row of the inverse
  /// of the basis is the ray. The primal one gives no reason, so the dual one is asked, without objective.
  void find_ray(std::vector<double>& ray) {
    set_objective({});
    glp_std_basis(problem_);
    if (run(GLP_DUAL) == 0 && glp_bf_exists(problem_)) read_ray(glp_get_unbnd_ray(problem_), ray);
    if (ray.empty()) ray = single_row_ray(model_);
    orient_ray(model_, ray);
  }

  void read_ray(int variable, std::vector<double>& ray) const {
    if (variable == 0) return;
    const int rows = glp_get_num_rows(problem_);
    const int position =
        variable <= rows ? glp_get_row_bind(problem_, variable) : glp_get_col_bind(problem_, variable - rows);
    if (position == 0) return;
    std::vector<double> inverse_row(at(rows) + 1, 0.0);
    inverse_row[at(position)] = 1;
    glp_btran(problem_, inverse_row.data());
    ray.assign(inverse_row.begin() + 1, inverse_row.end());
  }

  GlpkEnvironment environment_;  // goes after the problem
  bool cold_;
  glp_smcp control_{};
  glp_prob* problem_ = nullptr;
  LpModel model_;
  std::uint64_t structure_ = 0;
  std::vector<LinearTerm> objective_;
  std::vector<int> indices_;
  std::vector<double> values_;
};

}  // namespace

LpBackendVariant glpk_backend() {
  return {"glpk",
          "the primal simplex method of GLPK (Makhorin)",
          Promise::baseline,
          {start_option(), integer_option("iteration_limit", "pivots an objective may take", "pivots", 100000,
                                          1, 2000000000)},
          [](const Options& options) { return std::make_unique<GlpkBackend>(options); }};
}

}  // namespace gcslab
