// Whole reductions of boxes by Bernstein polytopes (bernstein_polytope.h), as
// `lp_reduction/<solver>/<start>/n`: both bounds of every unknown over one polytope, with rigorous bounds
// from the multipliers, over six boxes around the planted root in turn. Goals are taken nearest first and
// filtered, as the solver does, or
// (`every_goal`) all in order. Counters: what a reduction takes (per_reduction), programs solved and steps of
// a program.

#include <benchmark/benchmark.h>

#include "experiments/microbenchmarks/bernstein_polytope.h"
#include "linear_program/lp_reduction.h"
#include "linear_program/lp_registry.h"

namespace gcslab {
namespace {

constexpr int kBoxes = 6;
constexpr double kRadius = 0.2;

std::vector<LpModel> models(int unknowns) {
  RandomBernsteinPolytope polytope(unknowns, kRadius, static_cast<std::uint64_t>(unknowns));
  std::vector<LpModel> result;
  for (int box = 0; box < kBoxes; ++box) {
    result.push_back(polytope.model());
    polytope.move_box(kRadius);
  }
  return result;
}

struct Totals {
  long solved = 0;
  long iterations = 0;
  double width = 0;

  void add(const LpReductionResult& result, int unknowns) {
    solved += result.solved;
    iterations += result.iterations;
    for (int j = 0; j < unknowns; ++j) {
      const Interval& bounds = result.bounds[static_cast<std::size_t>(j)];
      width += (bounds.upper - bounds.lower) / 2 / unknowns;
    }
  }
  void report(benchmark::State& state, double reductions) const {
    state.counters["programs"] = static_cast<double>(solved) / reductions;
    state.counters["steps"] = static_cast<double>(iterations) / static_cast<double>(solved);
    state.counters["remaining_width"] = width / reductions;
    state.counters["per_reduction"] = benchmark::Counter(
        kBoxes, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  }
};

void lp_reduction(benchmark::State& state, const std::string& solver, const std::string& start,
                  bool every_goal) {
  const int unknowns = static_cast<int>(state.range(0));
  const std::vector<LpModel> boxes = models(unknowns);
  const std::vector<LpGoal> goals = both_sides(unknowns);
  const auto backend = lp_registry().at(solver).make_with({{"start", start}});
  LpReductionOptions options;
  options.nearest_first = !every_goal;
  if (every_goal) options.negligible_gain = -1;
  LpReduction reduction(*backend, options);
  Totals totals;
  for ([[maybe_unused]] auto iteration : state) {
    for (const LpModel& model : boxes) totals.add(reduction.reduce(model, goals), unknowns);
  }
  totals.report(state, static_cast<double>(state.iterations()) * kBoxes);
}

/// One rigorous bound from the multipliers of an optimum.
void lp_safe_bound(benchmark::State& state) {
  const RandomBernsteinPolytope polytope(static_cast<int>(state.range(0)), kRadius, 1);
  const auto backend = lp_registry().at("simplex").make_with();
  const LinearTerm objective{0, 1.0};
  backend->load(polytope.model());
  const std::vector<double> multipliers = backend->minimise({&objective, 1}).multipliers;
  SafeBound bound;
  for ([[maybe_unused]] auto iteration : state) {
    benchmark::DoNotOptimize(bound.lower(polytope.model(), {&objective, 1}, multipliers));
  }
}

void add(const std::string& solver, const std::string& start, bool every_goal, std::vector<int> sizes) {
  const std::string name = "lp_reduction/" + solver + "/" + start + (every_goal ? "/every_goal" : "");
  auto* made = benchmark::RegisterBenchmark(
      name.c_str(), [=](benchmark::State& state) { lp_reduction(state, solver, start, every_goal); });
  for (const int unknowns : sizes) made->Arg(unknowns);
  made->Unit(benchmark::kMillisecond);
}

bool add_all() {
  const std::vector<int> sizes = {4, 6, 8, 12, 16, 20, 30};
  for (const bool every_goal : {false, true}) {
    add("simplex", "warm", every_goal, sizes);
    add("glpk", "warm", every_goal, sizes);
    add("clp", "warm", every_goal, sizes);
  }
  add("simplex", "cold", false, sizes);
  add("glpk", "cold", false, sizes);
  add("exact", "warm", false, {4, 6, 8, 12});
  return true;
}

[[maybe_unused]] const bool kAdded = add_all();

BENCHMARK(lp_safe_bound)->Arg(4)->Arg(12)->Arg(30);

}  // namespace
}  // namespace gcslab
