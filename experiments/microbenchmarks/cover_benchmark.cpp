// Covers of the random curve of degree 18, and what an operation costs inside a tape.

#include <benchmark/benchmark.h>

#include "covering/cover.h"
#include "enclosure/bound_registry.h"
#include "enclosure/scoped_evaluator.h"
#include "experiments/corpus/corpus.h"
#include "experiments/corpus/problem.h"
#include "interval/affine_form.h"
#include "interval/arithmetic.h"
#include "interval/point_numbers.h"
#include "polynomial/horner.h"

namespace gcslab {
namespace {

const Problem& random_18() {
  static const Problem problem = load_problem(Corpus::standard().problem_path("curves/random-18"));
  return problem;
}

/// Counters: kept cells, and seconds for each of them.
void cover_random_18(benchmark::State& state, const std::string& bound, const std::string& form) {
  const Problem& problem = random_18();
  const BoundVariant& variant = bound_registry().at(bound);
  std::map<std::string, std::string> options;
  if (!form.empty()) options["form"] = form;
  SetBounds bounds;
  bounds.equations.push_back(
      variant.make(problem.targets().front(), Options(variant.options, options, bound)));
  std::uint64_t kept = 0;
  for (auto _ : state) {
    kept =
        cover(bounds, problem.system.box, {static_cast<int>(state.range(0)), Split::all}).tree.kept_cells();
  }
  state.counters["kept_cells"] = static_cast<double>(kept);
  state.counters["per_kept_cell"] = benchmark::Counter(
      static_cast<double>(kept), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

BENCHMARK_CAPTURE(cover_random_18, bernstein, "bernstein", "")
    ->DenseRange(8, 12)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(cover_random_18, natural_horner, "natural", "horner")
    ->DenseRange(8, 11)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(cover_random_18, natural_tightest, "natural", "tightest")
    ->DenseRange(8, 10)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(cover_random_18, taubin_even, "taubin_even", "")
    ->DenseRange(8, 11)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(cover_random_18, centred, "centred", "")->DenseRange(8, 10)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(cover_random_18, affine, "affine_chebyshev", "")
    ->DenseRange(8, 9)
    ->Unit(benchmark::kMillisecond);

/// Evaluates the Horner form once an iteration; the counter is the time of one operation of the tape.
template <class T>
void tape_operation(benchmark::State& state) {
  const Problem& problem = random_18();
  auto graph = std::make_shared<ExpressionGraph>();
  const Expression f = horner_form(problem.targets().front().polynomial(), *graph);
  const Tape tape(f, 2);
  const typename NumberTraits<T>::Scope scope(53);
  TapeEvaluator<T> evaluator(tape);
  std::vector<T> point;
  for (const double centre : {0.3, -0.2}) {
    if constexpr (NumberTraits<T>::is_set) {
      point.push_back(NumberTraits<T>::from_interval({centre, centre + 0.01}));
    } else {
      point.push_back(T(centre));
    }
  }
  for (auto _ : state) {
    evaluator.evaluate(point);
    benchmark::DoNotOptimize(evaluator.value());
  }
  state.counters["per_operation"] =
      benchmark::Counter(static_cast<double>(tape.instructions().size()),
                         benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

BENCHMARK(tape_operation<double>);
BENCHMARK(tape_operation<FastInterval>);
BENCHMARK(tape_operation<BoostInterval>);
BENCHMARK(tape_operation<MpfrInterval>);
BENCHMARK(tape_operation<ChebyshevAffine>);

}  // namespace
}  // namespace gcslab
