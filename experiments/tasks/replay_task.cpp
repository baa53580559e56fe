#include "experiments/tasks/replay_task.h"

#include <algorithm>
#include <cmath>

#include "box_solver/contractor_registry.h"
#include "box_solver/polytope.h"
#include "box_solver/search.h"
#include "experiments/corpus/problem_loader.h"
#include "experiments/tasks/job_result.h"
#include "experiments/tasks/stopwatch.h"
#include "linear_program/lp_reduction.h"
#include "linear_program/lp_registry.h"

namespace gcslab {
namespace {

/// Keeps what another contractor leaves of each box, unless that is a root with next to nothing around it.
class Recorder final : public Contractor {
 public:
  Recorder(std::unique_ptr<Contractor> contractor, const Box& search_box, std::vector<Box>& boxes)
      : contractor_(std::move(contractor)), search_box_(search_box), boxes_(&boxes) {}

  bool contract(Box& box, ProofTrace& trace) override {
    if (!contractor_->contract(box, trace)) return false;
    if (std::ranges::all_of(box, is_bounded) && is_wide(box)) boxes_->push_back(box);
    return true;
  }

 private:
  bool is_wide(const Box& box) const {
    constexpr double kNarrow = 1e-6;
    for (std::size_t i = 0; i < box.size(); ++i) {
      if (width(box[i]) >= kNarrow * std::min(width(search_box_[i]), 1.0)) return true;
    }
    return false;
  }

  std::unique_ptr<Contractor> contractor_;
  Box search_box_;
  std::vector<Box>* boxes_;
};

std::vector<Box> recorded_boxes(const SystemFunctions& functions, const Job& job,
                                const std::stop_token& stop) {
  std::vector<Box> all;
  const ContractorMaker maker = [&](const SystemFunctions& system, int) -> std::unique_ptr<Contractor> {
    return std::make_unique<Recorder>(make_contractor("hull+multipliers", system, {}), system.system().box,
                                      all);
  };
  SearchOptions options;
  options.maximum_boxes = static_cast<std::uint64_t>(job.parameters.integer("search_boxes"));
  options.maximum_bits = 53;
  const Box& box = functions.system().box;
  static_cast<void>(search(functions, box, {{box}}, maker, options, stop));
  const auto wanted = static_cast<std::size_t>(job.parameters.integer("boxes"));
  if (all.size() <= wanted) return all;
  std::vector<Box> chosen;
  for (std::size_t i = 0; i < wanted; ++i) chosen.push_back(all[i * all.size() / wanted]);
  return chosen;
}

std::vector<LpModel> models_of(const SystemFunctions& functions, const std::vector<Box>& boxes) {
  const NumberTraits<FastInterval>::Scope scope;
  const ExpansionPlan plan(functions, ExpandedFunctions::constraints);
  Expansion<FastInterval> expansion(plan);
  BernsteinPolytope polytope(plan);
  std::vector<LpModel> models;
  for (const Box& box : boxes) {
    expansion.expand(box);
    polytope.refill(expansion);
    models.push_back(polytope.model());
  }
  return models;
}

/// What reductions of all models together did.
struct Totals {
  long reductions = 0, infeasible = 0, programs = 0, steps = 0;

  void add(const LpReductionResult& result) {
    ++reductions;
    infeasible += result.infeasible ? 1 : 0;
    programs += result.solved;
    steps += result.iterations;
  }
};

/// Every bound of every model by itself, against the optimum that the own simplex method finds from scratch.
/// Distances are parts of the width of the scaled box, which is 2.
struct Accuracy {
  static constexpr double kEqual = 1e-9, kTight = 1e-6;

  long bounds = 0, unequal = 0, loose = 0;

  void compare(const LpModel& model, LpBackend& reference, LpBackend& backend, int unknowns) {
    reference.load(model);
    backend.load(model);
    for (const LpGoal& goal : both_sides(unknowns)) {
      const LinearTerm objective{goal.column, goal.side == BoundSide::lower ? 1.0 : -1.0};
      const LpSolution& right = reference.minimise({&objective, 1});
      const LpSolution& given = backend.minimise({&objective, 1});
      ++bounds;
      if (right.status != given.status) ++unequal;
      if (right.status != LpStatus::optimal || given.status != LpStatus::optimal) continue;
      if (!(std::abs(right.objective - given.objective) <= 2 * kEqual)) ++unequal;
      const double safe = safe_lower_bound(model, {&objective, 1}, given.multipliers);
      if (!(given.objective - safe <= 2 * kTight)) ++loose;
    }
  }
};

}  // namespace

std::string ReplayTask::summary() const {
  return "linear programs that a search met, solved again by one solver of linear programs";
}

std::vector<MethodInfo> ReplayTask::methods() const {
  std::vector<MethodInfo> methods;
  for (const LpBackendVariant& variant : lp_registry().entries())
    methods.push_back({variant.name, variant.summary, variant.promise, 1, variant.options});
  return methods;
}

std::vector<OptionSpec> ReplayTask::parameters() const {
  return {integer_option("boxes", "how many boxes of the search are reduced", "", 40, 1, 100000),
          integer_option("search_boxes", "after how many boxes the search ends", "", 2000, 1, 10000000)};
}

std::vector<ValueInfo> ReplayTask::values() const {
  return {{"columns", "of the linear programs: monomials other than 1"},
          {"rows", "of the linear programs"},
          {"reductions", "boxes reduced"},
          {"infeasible", "of them proved empty"},
          {"programs", "linear programs solved for them"},
          {"steps", "that these took"},
          {"bounds", "bounds compared with those of the own simplex method from scratch"},
          {"unequal", "of them further than 1e-9 of the box away"},
          {"loose", "of them that lose more than 1e-6 of the box when made rigorous"}};
}

std::vector<std::string> ReplayTask::problem_kinds() const { return system_kinds(); }

void ReplayTask::check(const Job& job) const { static_cast<void>(load_system(job.problem)); }

JobResult ReplayTask::run(const Job& job, const std::stop_token& stop) const {
  constexpr double kLongEnough = 0.2;
  const SystemFunctions functions(load_system(job.problem).system);
  const std::vector<LpModel> models = models_of(functions, recorded_boxes(functions, job, stop));
  const int unknowns = static_cast<int>(functions.variables());
  const auto backend = lp_registry().at(job.method).make(job.options);
  LpReduction reduction(*backend, {.negligible_gain = 1e-3});
  JobResult result;
  Totals totals;  // of the first pass: the number of passes depends on the machine
  long passes = 0;
  const Stopwatch watch;
  do {
    for (const LpModel& model : models) {
      const LpReductionResult& reduced = reduction.reduce(model, both_sides(unknowns));
      if (passes == 0) totals.add(reduced);
      if (stop.stop_requested())
        return {Status::budget_exhausted, "programs were left when the budget ended"};
    }
    ++passes;
  } while (watch.wall_s() < kLongEnough);
  const auto reductions = static_cast<double>(passes * totals.reductions);
  result.timings["wall_s"] = watch.wall_s() / reductions;
  result.timings["cpu_s"] = watch.cpu_s() / reductions;
  Accuracy accuracy;
  const auto fresh = lp_registry().at(job.method).make(job.options);
  const auto reference = lp_registry().at("simplex").make_with({{"start", "cold"}});
  for (const LpModel& model : models) {
    accuracy.compare(model, *reference, *fresh, unknowns);
    if (stop.stop_requested()) return {Status::budget_exhausted, "bounds were left when the budget ended"};
  }
  result.status = Status::partial;  // numbers of solvers, with nothing claimed
  result.values = {{"columns", models.empty() ? 0 : models.front().columns()},
                   {"rows", models.empty() ? 0 : models.front().rows()},
                   {"reductions", totals.reductions},
                   {"infeasible", totals.infeasible},
                   {"programs", totals.programs},
                   {"steps", totals.steps},
                   {"bounds", accuracy.bounds},
                   {"unequal", accuracy.unequal},
                   {"loose", accuracy.loose}};
  return result;
}

}  // namespace gcslab
