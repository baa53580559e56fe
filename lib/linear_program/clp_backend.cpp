// CLP (COIN-OR, Forrest and others) behind the interface, through its C interface.

#include <Clp_C_Interface.h>
#include <algorithm>
#include <memory>

#include "base/check.h"
#include "linear_program/lp_registry.h"

namespace gcslab {
namespace {

/// CLP's words for the state of a column or row.
enum class ClpState { is_free = 0, basic = 1, at_upper = 2, at_lower = 3, superbasic = 4, fixed = 5 };

LpActivity activity(int state) {
  switch (static_cast<ClpState>(state)) {
    case ClpState::at_upper:
      return LpActivity::at_upper;
    case ClpState::at_lower:
    case ClpState::fixed:
      return LpActivity::at_lower;
    default:
      return LpActivity::free;
  }
}

struct DeleteModel {
  void operator()(Clp_Simplex* model) const { Clp_deleteModel(model); }
};

class ClpBackend final : public LpBackend {
 public:
  explicit ClpBackend(const Options& options) : cold_(starts_cold(options)), model_of_clp_(Clp_newModel()) {
    Clp_setLogLevel(clp(), 0);
    Clp_setMaximumIterations(clp(), static_cast<int>(options.integer("iteration_limit")));
    Clp_setOptimizationDirection(clp(), 1);
  }

 protected:
  void load_model(const LpModel& model) override {
    model_ = model;
    basis_.clear();
    if (structure_ == model.structure() && Clp_statusExists(clp())) {
      basis_.assign(Clp_statusArray(clp()), Clp_statusArray(clp()) + model.columns() + model.rows());
    }
    structure_ = model.structure();
    read_columns();
    read_rows();
    Clp_loadProblem(clp(), model.columns(), model.rows(), column_start_.data(), entry_row_.data(),
                    entry_value_.data(), column_lower_.data(), column_upper_.data(), cost_.data(),
                    row_lower_.data(), row_upper_.data());
    if (!basis_.empty()) Clp_copyinStatus(clp(), basis_.data());
  }

  void solve(std::span<const LinearTerm> objective, LpSolution& solution) override {
    std::fill(cost_.begin(), cost_.end(), 0.0);
    for (const LinearTerm& term : objective) {
      cost_[static_cast<std::size_t>(term.column)] = midpoint(term.coefficient);
    }
    Clp_chgObjCoefficients(clp(), cost_.data());
    if (cold_) use_slack_basis();
    Clp_setNumberIterations(clp(), 0);
    Clp_primal(clp(), 0);
    const long iterations = Clp_numberIterations(clp());
    read(solution);
    solution.iterations = iterations;
  }

 private:
  Clp_Simplex* clp() const { return model_of_clp_.get(); }

  void read_columns() {
    column_lower_.clear();
    column_upper_.clear();
    for (int column = 0; column < model_.columns(); ++column) {
      column_lower_.push_back(model_.column(column).lower);
      column_upper_.push_back(model_.column(column).upper);
    }
    cost_.assign(column_lower_.size(), 0.0);
  }

  void read_rows() {
    row_lower_.clear();
    row_upper_.clear();
    std::vector<std::vector<std::pair<int, double>>> columns(cost_.size());
    for (int row = 0; row < model_.rows(); ++row) {
      row_lower_.push_back(model_.sides(row).lower);
      row_upper_.push_back(model_.sides(row).upper);
      const auto where = model_.row_columns(row);
      for (std::size_t k = 0; k < where.size(); ++k) {
        columns[static_cast<std::size_t>(where[k])].emplace_back(row, model_.row_midpoints(row)[k]);
      }
    }
    column_start_.assign(1, 0);
    entry_row_.clear();
    entry_value_.clear();
    for (const auto& column : columns) {
      for (const auto& [row, value] : column) {
        entry_row_.push_back(row);
        entry_value_.push_back(value);
      }
      column_start_.push_back(static_cast<int>(entry_row_.size()));
    }
  }

  void use_slack_basis() {
    for (int row = 0; row < model_.rows(); ++row) {
      Clp_setRowStatus(clp(), row, static_cast<int>(ClpState::basic));
    }
    for (int column = 0; column < model_.columns(); ++column) {
      Clp_setColumnStatus(clp(), column, static_cast<int>(ClpState::at_lower));
    }
  }

  void read(LpSolution& solution) {
    switch (Clp_status(clp())) {
      case 0:
        solution.status = LpStatus::optimal;
        return read_vertex(solution);
      case 1:
        solution.status = LpStatus::infeasible;
        return find_ray(solution.ray);
      case 3:
        solution.status = LpStatus::iteration_limit;
        return read_vertex(solution);
      default:
        solution.status = LpStatus::failed;
    }
  }

  void read_vertex(LpSolution& solution) const {
    const int columns = model_.columns();
    const int rows = model_.rows();
    solution.objective = Clp_objectiveValue(clp());
    const double* primal = Clp_primalColumnSolution(clp());
    const double* reduced = Clp_dualColumnSolution(clp());
    const double* multipliers = Clp_dualRowSolution(clp());
    solution.primal.assign(primal, primal + columns);
    solution.reduced_costs.assign(reduced, reduced + columns);
    solution.multipliers.assign(multipliers, multipliers + rows);
    solution.basis.columns.clear();
    solution.basis.rows.clear();
    for (int column = 0; column < columns; ++column) {
      solution.basis.columns.push_back(activity(Clp_getColumnStatus(clp(), column)));
    }
    for (int row = 0; row < rows; ++row) {
      solution.basis.rows.push_back(activity(Clp_getRowStatus(clp(), row)));
    }
  }

  /// Only the dual simplex leaves a ray.
  void find_ray(std::vector<double>& ray) {
    use_slack_basis();
    std::fill(cost_.begin(), cost_.end(), 0.0);
    Clp_chgObjCoefficients(clp(), cost_.data());
    Clp_dual(clp(), 0);
    double* found = Clp_status(clp()) == 1 ? Clp_infeasibilityRay(clp()) : nullptr;
    if (found == nullptr) {
      ray = single_row_ray(model_);
    } else {
      ray.assign(found, found + model_.rows());
      Clp_freeRay(clp(), found);
    }
    orient_ray(model_, ray);
  }

  bool cold_;
  std::unique_ptr<Clp_Simplex, DeleteModel> model_of_clp_;
  LpModel model_;
  std::uint64_t structure_ = 0;
  std::vector<unsigned char> basis_;
  std::vector<double> column_lower_, column_upper_, row_lower_, row_upper_, cost_, entry_value_;
  std::vector<int> column_start_, entry_row_;
};

}  // namespace

LpBackendVariant clp_backend() {
  return {"clp",
          "the primal simplex method of CLP (COIN-OR)",
          Promise::baseline,
          {start_option(), integer_option("iteration_limit", "pivots an objective may take", "pivots", 100000,
                                          1, 2000000000)},
          [](const Options& options) { return std::make_unique<ClpBackend>(options); }};
}

}  // namespace gcslab
