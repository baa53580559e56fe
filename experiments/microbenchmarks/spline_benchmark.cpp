// B-spline curves in the plane, as `spline/<what>/<n>/<degree>` with n + 1 control points: de_boor (de Boor's
// algorithm at each of 10^6 ordered parameters), grid (the same by one pass over the spans, curve_grid.h),
// insertion (a knot in the middle of each span), elevation (by one degree), bezier (all pieces), intersection
// (of two spirals). Counters: parameters_per_s; points and undecided ones of intersections. The two ways to
// evaluate side by side: --benchmark_filter='^spline/(de_boor|grid)'

#include <benchmark/benchmark.h>
#include <cmath>

#include "spline/curve_grid.h"
#include "spline/curve_intersection.h"
#include "spline/degree.h"

namespace gcslab {
namespace {

constexpr std::size_t kParameters = 1'000'000;

/// Clamped over [0, 1], with n + 1 points on a spiral that is turned by the phase.
BSplineCurve<double> spiral(int degree, std::size_t n, double phase = 0) {
  Matrix<double> points(n + 1, 2);
  for (std::size_t i = 0; i <= n; ++i) {
    const double part = static_cast<double>(i) / static_cast<double>(n);
    points(i, 0) = (0.5 + part) * std::cos(8 * part + phase);
    points(i, 1) = (0.5 + part) * std::sin(8 * part + phase);
  }
  return BSplineCurve<double>(
      clamped_uniform_knots(degree, n + 1 - static_cast<std::size_t>(degree), 0.0, 1.0), std::move(points));
}

std::vector<double> ordered_parameters() {
  std::vector<double> result(kParameters);
  for (std::size_t i = 0; i < kParameters; ++i)
    result[i] = static_cast<double>(i) / static_cast<double>(kParameters - 1);
  return result;
}

void count_parameters(benchmark::State& state) {
  state.counters["parameters_per_s"] =
      benchmark::Counter(static_cast<double>(kParameters), benchmark::Counter::kIsIterationInvariantRate);
}

void de_boor(benchmark::State& state, int degree, std::size_t n) {
  const auto curve = spiral(degree, n);
  const std::vector<double> parameters = ordered_parameters();
  Matrix<double> values(kParameters, 2);
  Matrix<double> work;
  for (auto _ : state) {
    for (std::size_t i = 0; i < kParameters; ++i) {
      de_boor_on_span(curve, curve.knots.find_span(parameters[i]), parameters[i], work);
      const auto value = work.row(work.rows() - 1);
      std::copy(value.begin(), value.end(), values.row(i).begin());
    }
    benchmark::DoNotOptimize(values.data());
  }
  count_parameters(state);
}

void grid(benchmark::State& state, int degree, std::size_t n) {
  const auto curve = spiral(degree, n);
  const std::vector<double> parameters = ordered_parameters();
  for (auto _ : state) benchmark::DoNotOptimize(evaluate_on_grid<double>(curve, parameters).data());
  count_parameters(state);
}

void insertion(benchmark::State& state, int degree, std::size_t n) {
  const auto curve = spiral(degree, n);
  std::vector<double> middles;
  for (const std::size_t k : curve.knots.spans())
    middles.push_back((curve.knots[k] + curve.knots[k + 1]) / 2);
  for (auto _ : state) benchmark::DoNotOptimize(refined(curve, middles).points.data());
}

void elevation(benchmark::State& state, int degree, std::size_t n) {
  const auto curve = spiral(degree, n);
  for (auto _ : state) benchmark::DoNotOptimize(elevated(curve).points.data());
}

void bezier(benchmark::State& state, int degree, std::size_t n) {
  const auto curve = spiral(degree, n);
  for (auto _ : state) benchmark::DoNotOptimize(bezier_pieces(curve).data());
}

void intersection_of_spirals(benchmark::State& state, int degree, std::size_t n) {
  const auto first = spiral(degree, n);
  auto second = spiral(degree, n, 1);
  for (std::size_t i = 0; i <= n; ++i) second.points(i, 1) = -second.points(i, 1);
  CurveIntersections found;
  for (auto _ : state) found = intersections(first, second);
  state.counters["points"] = static_cast<double>(found.points.size());
  state.counters["undecided"] = static_cast<double>(found.undecided.size());
}

using Run = void (*)(benchmark::State&, int, std::size_t);

void add(const std::string& name, Run run, int degree, std::size_t n, benchmark::TimeUnit unit) {
  benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) {
    run(state, degree, n);
  })->Unit(unit);
}

[[maybe_unused]] const bool registered = [] {
  const auto add_all = [](const std::string& what, Run run, benchmark::TimeUnit unit,
                          const std::vector<std::pair<std::size_t, int>>& sizes) {
    for (const auto& [n, degree] : sizes)
      add("spline/" + what + "/" + std::to_string(n) + "/" + std::to_string(degree), run, degree, n, unit);
  };
  const std::vector<std::pair<std::size_t, int>> evaluations = {{20, 1}, {20, 2},  {20, 3},  {20, 5},
                                                                {20, 7}, {200, 3}, {2000, 3}};
  const std::vector<std::pair<std::size_t, int>> changes = {{20, 3}, {200, 3}, {2000, 3},
                                                            {20, 7}, {200, 7}, {2000, 7}};
  add_all("de_boor", de_boor, benchmark::kMillisecond, evaluations);
  add_all("grid", grid, benchmark::kMillisecond, evaluations);
  add_all("insertion", insertion, benchmark::kMicrosecond, changes);
  add_all("elevation", elevation, benchmark::kMicrosecond, changes);
  add_all("bezier", bezier, benchmark::kMicrosecond, changes);
  add_all("intersection", intersection_of_spirals, benchmark::kMillisecond, {{20, 3}, {20, 5}, {200, 3}});
  return true;
}();

}  // namespace
}  // namespace gcslab
