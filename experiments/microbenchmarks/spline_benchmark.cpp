// B-spline curves in the plane, 21 control points unless said otherwise:
//   spline/de_boor/<degree>             de Boor's algorithm at each of 10^6 ordered parameters, no
//   allocation, spline/grid/<degree>                the same parameters by one pass over the spans
//   (curve_grid.h), spline/<way>_of_points/<n>/<degree> both against the number n + 1 of control points,
//   spline/insertion|elevation|bezier/<n>/<degree>, spline/intersection/<n>/<degree>
// Counter `parameters_per_s` where parameters are evaluated.

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
  for (const int degree : {1, 2, 3, 5, 7}) {
    add("spline/de_boor/" + std::to_string(degree), de_boor, degree, 20, benchmark::kMillisecond);
    add("spline/grid/" + std::to_string(degree), grid, degree, 20, benchmark::kMillisecond);
  }
  for (const std::size_t n : {20U, 200U, 2000U}) {
    const std::string size = "/" + std::to_string(n) + "/";
    add("spline/de_boor_of_points" + size + "3", de_boor, 3, n, benchmark::kMillisecond);
    add("spline/grid_of_points" + size + "3", grid, 3, n, benchmark::kMillisecond);
    for (const int degree : {3, 7}) {
      add("spline/insertion" + size + std::to_string(degree), insertion, degree, n, benchmark::kMicrosecond);
      add("spline/elevation" + size + std::to_string(degree), elevation, degree, n, benchmark::kMicrosecond);
      add("spline/bezier" + size + std::to_string(degree), bezier, degree, n, benchmark::kMicrosecond);
    }
  }
  for (const int degree : {3, 5})
    add("spline/intersection/20/" + std::to_string(degree), intersection_of_spirals, degree, 20,
        benchmark::kMillisecond);
  return true;
}();

}  // namespace
}  // namespace gcslab
