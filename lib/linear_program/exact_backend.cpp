// The true optimum over the midpoints: our simplex method in doubles, finished in exact rationals from its
// last basis.

#include <memory>

#include "linear_program/exact_simplex.h"
#include "linear_program/lp_registry.h"
#include "linear_program/simplex.h"

namespace gcslab {
namespace {

std::vector<double> nearest(const std::vector<Rational>& values) {
  std::vector<double> result;
  for (const Rational& value : values) result.push_back(nearest_double(value));
  return result;
}

class ExactBackend final : public LpBackend {
 public:
  explicit ExactBackend(const Options& options)
      : simplex_({starts_cold(options), 20000}), step_limit_(options.integer("iteration_limit")) {}

 protected:
  void load_model(const LpModel& model) override {
    simplex_.load(model);
    exact_ = std::make_unique<ExactSimplex>(model);
  }

  void solve(std::span<const LinearTerm> objective, LpSolution& solution) override {
    simplex_.minimise(objective, solution);
    const bool has_basis = solution.status == LpStatus::optimal || solution.status == LpStatus::infeasible;
    const LpBasis start = has_basis ? solution.basis : LpBasis{};
    const ExactSolution exact = exact_->minimise(objective, start, static_cast<long>(step_limit_));
    solution.status = exact.status;
    solution.iterations += exact.steps;
    solution.ray.clear();
    if (exact.status == LpStatus::infeasible) solution.ray = nearest(exact.multipliers);
    if (exact.status != LpStatus::optimal) return;
    solution.objective = nearest_double(exact.objective);
    solution.primal = nearest(exact.primal);
    solution.multipliers = nearest(exact.multipliers);
    solution.reduced_costs = nearest(exact.reduced_costs);
    solution.basis = exact.basis;
  }

 private:
  Simplex simplex_;
  std::int64_t step_limit_;
  std::unique_ptr<ExactSimplex> exact_;
};

}  // namespace

LpBackendVariant exact_backend() {
  return {"exact",
          "the true optimum over the midpoints, in rationals, from the last basis of `simplex`",
          Promise::rigorous,
          {start_option(), integer_option("iteration_limit", "exact steps an objective may take", "steps",
                                          1000000, 1, 2000000000)},
          [](const Options& options) { return std::make_unique<ExactBackend>(options); }};
}

}  // namespace gcslab
