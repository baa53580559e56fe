// The cost of polynomial bounds: halvings and ranges of tensors, as a share of the processor's peak, and
// conversions.
//
// Counters of a halving: `flops` counts one for each addition of de Casteljau (two intervals: two additions)
// and none for the scaling; `peak_flops` counts two for each multiply-add of the loop measured beside it;
// `share` is their quotient, which additions alone can bring to 1/2 at most; `issue_share` is additions
// against multiply-adds, which says how busy the arithmetic units are.

#include <algorithm>
#include <benchmark/benchmark.h>
#include <chrono>

#include "base/random.h"
#include "interval/arithmetic.h"
#include "interval/point_numbers.h"
#include "polynomial/bernstein.h"
#include "polynomial/power.h"

namespace gcslab {
namespace {

constexpr long kPeakRounds = 2'000'000;

/// Multiply-adds of doubles a second, twelve chains of vectors of four at once.
[[gnu::noinline]] double multiply_adds_per_second_once() {
  const __m256d a = _mm256_set1_pd(0.999);
  const __m256d b = _mm256_set1_pd(0.001);
  // Different starts, or the compiler sees that all chains are one.
  __m256d x0 = _mm256_set1_pd(0), x1 = x0 + b, x2 = x1 + b, x3 = x2 + b, x4 = x3 + b, x5 = x4 + b;
  __m256d x6 = x5 + b, x7 = x6 + b, x8 = x7 + b, x9 = x8 + b, x10 = x9 + b, x11 = x10 + b;
  const auto start = std::chrono::steady_clock::now();
  for (long i = 0; i < kPeakRounds; ++i) {
    x0 = _mm256_fmadd_pd(x0, a, b), x1 = _mm256_fmadd_pd(x1, a, b), x2 = _mm256_fmadd_pd(x2, a, b);
    x3 = _mm256_fmadd_pd(x3, a, b), x4 = _mm256_fmadd_pd(x4, a, b), x5 = _mm256_fmadd_pd(x5, a, b);
    x6 = _mm256_fmadd_pd(x6, a, b), x7 = _mm256_fmadd_pd(x7, a, b), x8 = _mm256_fmadd_pd(x8, a, b);
    x9 = _mm256_fmadd_pd(x9, a, b), x10 = _mm256_fmadd_pd(x10, a, b), x11 = _mm256_fmadd_pd(x11, a, b);
  }
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  benchmark::DoNotOptimize(x0 + x1 + x2 + x3 + x4 + x5 + x6 + x7 + x8 + x9 + x10 + x11);
  return 12.0 * 4.0 * static_cast<double>(kPeakRounds) / seconds.count();
}

double multiply_adds_per_second() {
  static const double peak = [] {
    double best = 0;
    for (int i = 0; i < 20; ++i) best = std::max(best, multiply_adds_per_second_once());
    return best;
  }();
  return peak;
}

template <class T, template <class> class TensorOf>
TensorOf<T> random_tensor(const Exponents& degrees) {
  Random random(1, "benchmark");
  std::vector<T> values;
  for (std::size_t i = coefficient_count(degrees); i > 0; --i) {
    values.push_back(NumberTraits<T>::from_rational(rational_from_double(random.uniform(-1, 1))));
  }
  return TensorOf<T>(degrees, std::move(values));
}

/// Additions of one halving: degree * (degree + 1) / 2 a column, `triangles` times, on two doubles.
template <class T, template <class> class TensorOf>
void halving(benchmark::State& state, const Exponents& degrees, int variable, int triangles) {
  const typename NumberTraits<T>::Scope scope;
  const auto tensor = random_tensor<T, TensorOf>(degrees);
  TensorOf<T> left, right;
  for (auto _ : state) {
    tensor.halve(variable, left, right);
    benchmark::DoNotOptimize(left.coefficients().data());
    benchmark::DoNotOptimize(right.coefficients().data());
    benchmark::ClobberMemory();
  }
  const AxisShape shape = tensor.shape(variable);
  const auto count = static_cast<double>(shape.count);
  const double additions =
      count * (count - 1) / 2 * 2 * static_cast<double>(shape.blocks * shape.row) * triangles;
  const double total = additions * static_cast<double>(state.iterations());
  const double peak = multiply_adds_per_second();
  state.counters["flops"] = benchmark::Counter(total, benchmark::Counter::kIsRate);
  state.counters["peak_flops"] = 2 * peak;
  state.counters["share"] = benchmark::Counter(total / (2 * peak), benchmark::Counter::kIsRate);
  state.counters["issue_share"] = benchmark::Counter(total / peak, benchmark::Counter::kIsRate);
}

template <class T>
void bernstein_halving(benchmark::State& state, const Exponents& degrees, int variable) {
  halving<T, BernsteinTensor>(state, degrees, variable, 1);
}

template <class T>
void power_halving(benchmark::State& state, const Exponents& degrees, int variable) {
  halving<T, PowerTensor>(state, degrees, variable, 2);
}

template <class T>
void bernstein_range(benchmark::State& state, const Exponents& degrees) {
  const typename NumberTraits<T>::Scope scope;
  const auto tensor = random_tensor<T, BernsteinTensor>(degrees);
  for (auto _ : state) benchmark::DoNotOptimize(tensor.range());
}

void taubin(benchmark::State& state, const Exponents& degrees, TaubinVariant variant) {
  const NumberTraits<FastInterval>::Scope scope;
  const auto tensor = random_tensor<FastInterval, PowerTensor>(degrees);
  for (auto _ : state) benchmark::DoNotOptimize(taubin_range(tensor, variant));
}

Polynomial dense_polynomial(const Exponents& degrees) {
  Random random(1, "benchmark");
  Polynomial result(static_cast<int>(degrees.size()));
  Exponents index(degrees.size(), 0);
  do {
    result.add_term(index, Rational(random.integer(-1000, 1000)) / 1000);
  } while (next_index(index, degrees));
  return result;
}

const RationalBox& box_of_conversion() {
  static const RationalBox box(2, {Rational(-3, 2), Rational(2)});
  return box;
}

template <class T>
void conversion(benchmark::State& state, const Exponents& degrees) {
  const typename NumberTraits<T>::Scope scope;
  const Polynomial polynomial = dense_polynomial(degrees);
  for (auto _ : state) {
    benchmark::DoNotOptimize(bernstein_from_polynomial<T>(polynomial, box_of_conversion()));
  }
}

template <class T>
void conversion_in_arithmetic(benchmark::State& state, const Exponents& degrees) {
  const typename NumberTraits<T>::Scope scope;
  const Polynomial polynomial = dense_polynomial(degrees);
  for (auto _ : state) {
    benchmark::DoNotOptimize(bernstein_computed_in<T>(polynomial, box_of_conversion()));
  }
}

const Exponents kPlane{18, 18};
const Exponents kSpace{6, 6, 6};
const Exponents kLine{30};

void register_halvings() {
  using benchmark::RegisterBenchmark;
  RegisterBenchmark("bernstein_halving/fast/19x19/first", bernstein_halving<FastInterval>, kPlane, 0);
  RegisterBenchmark("bernstein_halving/fast/19x19/last", bernstein_halving<FastInterval>, kPlane, 1);
  RegisterBenchmark("bernstein_halving/fast/7x7x7/first", bernstein_halving<FastInterval>, kSpace, 0);
  RegisterBenchmark("bernstein_halving/fast/7x7x7/middle", bernstein_halving<FastInterval>, kSpace, 1);
  RegisterBenchmark("bernstein_halving/fast/7x7x7/last", bernstein_halving<FastInterval>, kSpace, 2);
  RegisterBenchmark("bernstein_halving/fast/31", bernstein_halving<FastInterval>, kLine, 0);
  RegisterBenchmark("bernstein_halving/double/19x19/first", bernstein_halving<double>, kPlane, 0);
  RegisterBenchmark("bernstein_halving/boost/19x19/first", bernstein_halving<BoostInterval>, kPlane, 0);
  RegisterBenchmark("bernstein_halving/mpfr/19x19/first", bernstein_halving<MpfrInterval>, kPlane, 0);
  RegisterBenchmark("power_halving/fast/19x19/first", power_halving<FastInterval>, kPlane, 0);
  RegisterBenchmark("power_halving/fast/19x19/last", power_halving<FastInterval>, kPlane, 1);
  RegisterBenchmark("power_halving/fast/7x7x7/last", power_halving<FastInterval>, kSpace, 2);
}

void register_ranges_and_conversions() {
  using benchmark::RegisterBenchmark;
  RegisterBenchmark("bernstein_range/fast/19x19", bernstein_range<FastInterval>, kPlane);
  RegisterBenchmark("bernstein_range/boost/19x19", bernstein_range<BoostInterval>, kPlane);
  RegisterBenchmark("taubin_range/plain/19x19", taubin, kPlane, TaubinVariant::plain);
  RegisterBenchmark("taubin_range/even/19x19", taubin, kPlane, TaubinVariant::even);
  RegisterBenchmark("conversion/exact_to_fast/19x19", conversion<FastInterval>, kPlane);
  RegisterBenchmark("conversion/in_fast/19x19", conversion_in_arithmetic<FastInterval>, kPlane);
  RegisterBenchmark("conversion/in_double/19x19", conversion_in_arithmetic<double>, kPlane);
}

[[maybe_unused]] const bool kRegistered = (register_halvings(), register_ranges_and_conversions(), true);

}  // namespace
}  // namespace gcslab
