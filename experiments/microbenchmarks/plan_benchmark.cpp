// Construction plans, as `plan/<problem>/<method>`: one whole run of a method of `solve` each iteration, plan
// and formulas included. Counters: classes of figures found, of those the ones that are not flat, guides,
// steps (simplices, of plan_pli), and, where there is one, `goal_s`: the wall time that a run is to stay
// under, and `of_goal`: the share of it that was taken. All goals side by side:
// --benchmark_filter=^plan/

#include <algorithm>
#include <benchmark/benchmark.h>
#include <chrono>
#include <map>

#include "experiments/corpus/problem_loader.h"
#include "experiments/solving/figure_picture.h"
#include "experiments/solving/solve_method.h"

namespace gcslab {
namespace {

struct PlanGoal {
  const char* problem;
  const char* method;
  std::map<std::string, std::string> options;
  double goal_s;  ///< 0: none
};

void count(benchmark::State& state, const Problem& problem, const SolveOutcome& found) {
  const FigurePicture picture = figure_picture(*problem.geometry, found.search);
  const auto flat = std::ranges::count_if(
      picture.figures, [](const PicturedFigure& figure) { return is_flat(figure.places); });
  state.counters["classes"] = static_cast<double>(picture.figures.size());
  state.counters["not_flat"] = static_cast<double>(std::ssize(picture.figures) - flat);
  if (found.plan) state.counters["guides"] = static_cast<double>(found.plan->guides);
  if (found.steps) state.counters["steps"] = static_cast<double>(*found.steps);
}

void run_plan(benchmark::State& state, const PlanGoal& goal) {
  const SolveMethod& method = solve_method_registry().at(goal.method);
  SolveSettings settings{goal.method, Options(method.options, goal.options, goal.method)};
  const Problem problem = load_system(goal.problem, settings.options.word("valuation"));
  const SystemFunctions functions(problem.system);
  settings.geometry = problem.geometry.get();
  SolveOutcome found;
  double total_s = 0;
  for (auto _ : state) {
    const auto start = std::chrono::steady_clock::now();
    found = solve_system(functions, settings, std::nullopt, {});
    total_s += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }
  count(state, problem, found);
  if (goal.goal_s == 0) return;
  state.counters["goal_s"] = goal.goal_s;
  state.counters["of_goal"] = total_s / static_cast<double>(state.iterations()) / goal.goal_s;
}

[[maybe_unused]] const bool registered = [] {
  const std::vector<PlanGoal> goals = {
      {"polyhedra/octahedron", "plan_pli", {}, 0.1},
      {"polyhedra/octahedron", "plan_path", {}, 0.002},
      {"polyhedra/octahedron", "sketch_path", {}, 0},
      {"polyhedra/pentahedron", "plan_exploration", {{"valuation", "section_3_4"}}, 0.1},
      {"polyhedra/pentahedron", "plan_exploration", {{"valuation", "table_4_1"}}, 0.1},
      {"molecules/disulfide-distances", "plan_exploration", {}, 1},
      {"polyhedra/hexahedron", "plan_exploration", {}, 10},
      {"polyhedra/icosahedron", "plan_path", {}, 0},
      {"polyhedra/icosahedron", "plan_pli", {{"until", "first_crossing"}, {"mesh", "0.001"}}, 0}};
  for (const PlanGoal& goal : goals) {
    std::string name = std::string("plan/") + goal.problem + "/" + goal.method;
    for (const auto& [option, value] : goal.options) name += "/" + option + "=" + value;
    benchmark::RegisterBenchmark(name.c_str(), [goal](benchmark::State& state) {
      run_plan(state, goal);
    })->Unit(benchmark::kMillisecond);
  }
  return true;
}();

}  // namespace
}  // namespace gcslab
