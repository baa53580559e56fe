// Whole homotopy paths of sketches, as `sketch_path/<problem>/<tracker>`: followed to the end, every crossing
// of t = 1 polished, regular ones certified, solutions told apart. `usual` is the tracker of the method
// sketch_path, `as_published` that of sketch_path_as_published. Counters: solutions, steps and time a step
// (all of the time divided by steps). `sketch_path/<problem>/random` is `usual` from 20 random sketches, one
// after the other: its counters are medians over them. `published_ratio/<problem>` runs both trackers in
// turn; its counter `ratio` says how many times faster the usual one is. `tracker_step/<problem>` is the
// following alone, without certificates; `tracker_step/<family>/<size>/dense` or `sparse` the first steps of
// a figure of that size (unknowns: a counter), and `bordered_matrix/...` one factorisation and solution
// there.

#include <algorithm>
#include <benchmark/benchmark.h>
#include <chrono>

#include "experiments/corpus/figure_family.h"
#include "experiments/corpus/problem_loader.h"
#include "geometry/frame.h"
#include "geometry/sketch.h"
#include "homotopy/sketch_homotopy.h"
#include "homotopy/sketch_solver.h"

namespace gcslab {
namespace {

constexpr const char* kProblems[] = {"polyhedra/octahedron", "polyhedra/pentahedron", "polyhedra/hexahedron",
                                     "molecules/disulfide-distances", "polyhedra/icosahedron"};
constexpr const char* kCertifier = "krawczyk_slopes+kantorovich";

TrackerOptions as_published() {
  TrackerOptions options;
  options.predictor = "euler";
  options.corrector = {CorrectorKind::newton, 1e-10};
  options.step_control = StepControl::fixed;
  options.first_step = 0.1;
  return options;
}

ConstraintSystem with_random_sketch(ConstraintSystem system, std::uint64_t seed) {
  system.sketch.reset();
  system.random_sketch = seed;
  return system;
}

/// A problem with the homotopy of its sketch, or of a random one.
struct Sketched {
  explicit Sketched(const std::string& name) : Sketched(load_system(name), std::nullopt) {}
  Sketched(Problem given, std::optional<std::uint64_t> seed)
      : problem(std::move(given)),
        functions(problem.system),
        homotopy(problem.geometry->system, problem.geometry->frame, problem.geometry->equations,
                 values_of(problem.geometry->system.valuation(problem.geometry->valuation)),
                 *sketch_of(seed ? with_random_sketch(problem.geometry->system, *seed)
                                 : problem.geometry->system)) {}

  Problem problem;
  SystemFunctions functions;
  SketchHomotopy homotopy;
};

void count(benchmark::State& state, std::size_t solutions, std::uint64_t steps) {
  state.counters["solutions"] = static_cast<double>(solutions);
  state.counters["steps"] = static_cast<double>(steps);
  state.counters["per_step"] =
      benchmark::Counter(static_cast<double>(steps),
                         benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void sketch_path(benchmark::State& state, const std::string& name, bool is_published) {
  Sketched sketched(name);
  const auto differences = with_forward_differences(sketched.homotopy.curve());
  Curve& curve = is_published ? *differences : sketched.homotopy.curve();
  const TrackerOptions options = is_published ? as_published() : TrackerOptions{};
  SketchSolutions found;
  for (auto _ : state) {
    found = solve_along_path(sketched.homotopy.curve(), curve, sketched.homotopy.start(), sketched.functions,
                             options, kCertifier);
  }
  count(state, found.solutions.size(), found.path.steps);
}

double median(std::vector<double> values) {
  std::ranges::sort(values);
  return values[values.size() / 2];
}

void random_sketches(benchmark::State& state, const std::string& name) {
  constexpr std::uint64_t kSketches = 20;
  std::vector<std::unique_ptr<Sketched>> sketches;
  for (std::uint64_t seed = 1; seed <= kSketches; ++seed)
    sketches.push_back(std::make_unique<Sketched>(load_system(name), seed));
  std::vector<double> times, solutions, steps;
  for (auto _ : state) {
    times.clear(), solutions.clear(), steps.clear();
    for (const auto& sketched : sketches) {
      const auto start = std::chrono::steady_clock::now();
      Curve& curve = sketched->homotopy.curve();
      const SketchSolutions found = solve_along_path(
          sketched->homotopy.curve(), curve, sketched->homotopy.start(), sketched->functions, {}, kCertifier);
      times.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
      solutions.push_back(static_cast<double>(found.solutions.size()));
      steps.push_back(static_cast<double>(found.path.steps));
    }
  }
  state.counters["median_ms"] = 1000 * median(times);
  state.counters["most_ms"] = 1000 * std::ranges::max(times);
  state.counters["solutions"] = median(solutions);
  state.counters["steps"] = median(steps);
}

void published_ratio(benchmark::State& state, const std::string& name) {
  Sketched sketched(name);
  const auto differences = with_forward_differences(sketched.homotopy.curve());
  double usual = 0, published = 0;
  const auto timed = [&](Curve& curve, const TrackerOptions& options, double& total) {
    const auto start = std::chrono::steady_clock::now();
    benchmark::DoNotOptimize(solve_along_path(sketched.homotopy.curve(), curve, sketched.homotopy.start(),
                                              sketched.functions, options, kCertifier));
    total += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  for (auto _ : state) {
    timed(sketched.homotopy.curve(), {}, usual);
    timed(*differences, as_published(), published);
  }
  state.counters["ratio"] = published / usual;
}

void tracker_step(benchmark::State& state, const std::string& name) {
  Sketched sketched(name);
  Path path;
  for (auto _ : state) path = follow_path(sketched.homotopy.curve(), sketched.homotopy.start(), {});
  count(state, path.crossings.size(), path.steps);
}

/// A member of a family with the homotopy of its sketch.
struct Member {
  Member(const std::string& family, int size, LinearAlgebra linear_algebra)
      : system(family_figure({family, size}).system),
        frame(frame_of(system)),
        equations(geometric_equations(system, frame)),
        homotopy(system, frame, equations, values_of(system.valuations.front()), *system.sketch,
                 {.booleans = Booleans::kept, .linear_algebra = linear_algebra}) {}

  ConstraintSystem system;
  Frame frame;
  GeometricEquations equations;
  SketchHomotopy homotopy;
};

void member_steps(benchmark::State& state, const std::string& family, int size,
                  LinearAlgebra linear_algebra) {
  Member member(family, size, linear_algebra);
  Curve& curve = member.homotopy.curve();
  TrackerOptions options;
  options.maximum_steps = 20;
  Path path;
  for (auto _ : state) path = follow_path(curve, member.homotopy.start(), options);
  count(state, path.crossings.size(), path.steps);
  state.counters["unknowns"] = static_cast<double>(curve.size());
}

void bordered_matrix(benchmark::State& state, const std::string& family, int size,
                     LinearAlgebra linear_algebra) {
  Member member(family, size, linear_algebra);
  Curve& curve = member.homotopy.curve();
  const std::size_t m = curve.size();
  BorderedMatrix matrix(curve.pattern());
  std::vector<double> values(m), result(m + 1), border(m + 1, 0.1);
  Matrix<double> jacobian(m, m + 1);
  curve.jacobian(member.homotopy.start(), values, jacobian);
  for (auto _ : state) {
    benchmark::DoNotOptimize(matrix.factorise(jacobian, border));
    matrix.solve(values, 1, result);
    benchmark::DoNotOptimize(result.data());
  }
  state.counters["unknowns"] = static_cast<double>(m);
}

void add_family(const std::string& family, std::initializer_list<int> sizes) {
  for (const int size : sizes) {
    for (const LinearAlgebra kind : {LinearAlgebra::dense, LinearAlgebra::sparse}) {
      const std::string text =
          family + "/" + std::to_string(size) + (kind == LinearAlgebra::dense ? "/dense" : "/sparse");
      benchmark::RegisterBenchmark(("tracker_step/" + text).c_str(), [=](benchmark::State& state) {
        member_steps(state, family, size, kind);
      })->Unit(benchmark::kMicrosecond);
      benchmark::RegisterBenchmark(("bordered_matrix/" + text).c_str(), [=](benchmark::State& state) {
        bordered_matrix(state, family, size, kind);
      })->Unit(benchmark::kMicrosecond);
    }
  }
}

[[maybe_unused]] const bool registered = [] {
  for (const std::string name : kProblems) {
    const auto add = [&](const std::string& text, auto&& run) {
      benchmark::RegisterBenchmark(text.c_str(), run)->Unit(benchmark::kMicrosecond);
    };
    add("sketch_path/" + name + "/usual",
        [name](benchmark::State& state) { sketch_path(state, name, false); });
    add("tracker_step/" + name, [name](benchmark::State& state) { tracker_step(state, name); });
    if (name == "polyhedra/icosahedron") continue;  // hours
    add("sketch_path/" + name + "/random", [name](benchmark::State& state) { random_sketches(state, name); });
    add("sketch_path/" + name + "/as_published",
        [name](benchmark::State& state) { sketch_path(state, name, true); });
    add("published_ratio/" + name, [name](benchmark::State& state) { published_ratio(state, name); });
  }
  add_family("polygon", {7, 16, 33, 52, 77, 102, 152});
  add_family("triangulated_polyhedron", {6, 12, 22, 35, 52, 69, 102});
  add_family("prism", {5, 13, 21, 31, 60});
  return true;
}();

}  // namespace
}  // namespace gcslab
