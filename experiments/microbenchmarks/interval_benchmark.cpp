// Cost of one operation for each number type (affine forms: with the making of two variables), as
// `interval_op/<type>/<operation>`, over arrays of independent operands, and as
// `interval_tape/<type>/<operation>` inside an interpreter like a tape's: fetch an instruction, read two
// registers, write one. Counter ns_per_op is what to compare; the goal is interval_tape/fast within 5 times
// interval_tape/double.

#include <array>
#include <benchmark/benchmark.h>
#include <string>
#include <type_traits>
#include <vector>

#include "base/random.h"
#include "interval/affine_form.h"
#include "interval/boost_interval.h"
#include "interval/fast_interval.h"
#include "interval/mpfr_interval.h"
#include "interval/point_numbers.h"
#include "interval/unrounded_interval.h"

namespace gcslab {
namespace {

enum class Operation { add, subtract, multiply, divide, sqr, cube, sqrt, min, exp, log, sin, atan };

struct NamedOperation {
  Operation operation;
  const char* name;
};

constexpr std::array kOperations = {
    NamedOperation{Operation::add, "add"},           NamedOperation{Operation::subtract, "subtract"},
    NamedOperation{Operation::multiply, "multiply"}, NamedOperation{Operation::divide, "divide"},
    NamedOperation{Operation::sqr, "sqr"},           NamedOperation{Operation::cube, "cube"},
    NamedOperation{Operation::sqrt, "sqrt"},         NamedOperation{Operation::min, "min"},
    NamedOperation{Operation::exp, "exp"},           NamedOperation{Operation::log, "log"},
    NamedOperation{Operation::sin, "sin"},           NamedOperation{Operation::atan, "atan"}};

template <class T>
inline T apply(Operation operation, const T& x, const T& y) {
  switch (operation) {
    case Operation::add:
      return x + y;
    case Operation::subtract:
      return x - y;
    case Operation::multiply:
      return x * y;
    case Operation::divide:
      return x / y;
    case Operation::sqr:
      return sqr(x);
    case Operation::cube:
      return pow(x, 3);
    case Operation::sqrt:
      return sqrt(x);
    case Operation::min:
      return min(x, y);
    case Operation::exp:
      return exp(x);
    case Operation::log:
      return log(x);
    case Operation::sin:
      return sin(x);
    case Operation::atan:
      break;
  }
  return atan(x);
}

constexpr std::size_t kOperands = 256;

/// Operands of all signs; every fourth interval contains 0.
template <class T>
std::vector<T> operands(const char* stream) {
  Random random(1, stream);
  std::vector<T> values;
  for (std::size_t i = 0; i < kOperands; ++i) {
    const double centre = random.uniform(0.5, 4) * (random.below(2) == 0 ? 1 : -1);
    const double radius = i % 4 == 0 ? 5 : 0.01;
    if constexpr (std::is_floating_point_v<T>) {
      values.push_back(centre);
    } else {
      values.push_back(NumberTraits<T>::from_interval({centre - radius, centre + radius}));
    }
  }
  return values;
}

void count_operations(benchmark::State& state) {
  state.counters["ns_per_op"] =
      benchmark::Counter(static_cast<double>(kOperands) * 1e-9,
                         benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

/// One operation on each pair of operands; the operation is known at compile time.
template <class T, Operation operation>
void run_array(benchmark::State& state, int bits) {
  const typename NumberTraits<T>::Scope scope(bits);
  const std::vector<T> x = operands<T>("left");
  const std::vector<T> y = operands<T>("right");
  std::vector<T> results = x;
  for ([[maybe_unused]] auto iteration : state) {
    for (std::size_t i = 0; i < kOperands; ++i) results[i] = apply(operation, x[i], y[i]);
    benchmark::DoNotOptimize(results.data());
    benchmark::ClobberMemory();
  }
  count_operations(state);
}

struct Instruction {
  Operation operation;
  unsigned result;
  unsigned left;
  unsigned right;
};

/// The same through instructions whose operation the compiler does not know.
template <class T>
void run_tape(benchmark::State& state, Operation operation, int bits) {
  const typename NumberTraits<T>::Scope scope(bits);
  std::vector<T> registers = operands<T>("left");
  for (const T& value : operands<T>("right")) registers.push_back(value);
  std::vector<Instruction> tape;
  constexpr auto kCount = static_cast<unsigned>(kOperands);
  for (unsigned i = 0; i < kCount; ++i) {
    registers.push_back(registers[i]);
    tape.push_back({operation, 2 * kCount + i, i, kCount + i});
  }
  benchmark::DoNotOptimize(tape.data());
  for ([[maybe_unused]] auto iteration : state) {
    benchmark::ClobberMemory();
    for (const Instruction& instruction : tape) {
      registers[instruction.result] =
          apply(instruction.operation, registers[instruction.left], registers[instruction.right]);
    }
  }
  count_operations(state);
}

/// The operation on two variables, made in a scope of their own as in one evaluation of an expression.
template <class Form>
void run_affine(benchmark::State& state, Operation operation) {
  Random random(1, "affine");
  std::vector<Interval> boxes;
  for (std::size_t i = 0; i <= kOperands; ++i) {
    const double centre = random.uniform(0.5, 4);
    boxes.emplace_back(centre - 0.01, centre + 0.01);
  }
  for ([[maybe_unused]] auto iteration : state) {
    for (std::size_t i = 0; i < kOperands; ++i) {
      const typename NumberTraits<Form>::Scope scope;
      const Form x = NumberTraits<Form>::from_interval(boxes[i]);
      const Form y = NumberTraits<Form>::from_interval(boxes[i + 1]);
      benchmark::DoNotOptimize(apply(operation, x, y).range());
    }
  }
  count_operations(state);
}

template <class Form>
void add_affine(const std::string& type) {
  for (const NamedOperation& operation : kOperations) {
    benchmark::RegisterBenchmark(
        ("interval_op/" + type + "/" + operation.name).c_str(),
        [operation](benchmark::State& state) { run_affine<Form>(state, operation.operation); });
  }
}

template <class T, Operation operation>
void add_array(const std::string& type, int bits) {
  const std::string name =
      "interval_op/" + type + "/" + kOperations[static_cast<std::size_t>(operation)].name;
  benchmark::RegisterBenchmark(name.c_str(),
                               [bits](benchmark::State& state) { run_array<T, operation>(state, bits); });
}

template <class T, std::size_t... indices>
void add_type(const std::string& type, int bits, std::index_sequence<indices...>) {
  (add_array<T, kOperations[indices].operation>(type, bits), ...);
  for (const NamedOperation& operation : kOperations) {
    benchmark::RegisterBenchmark(
        ("interval_tape/" + type + "/" + operation.name).c_str(),
        [bits, operation](benchmark::State& state) { run_tape<T>(state, operation.operation, bits); });
  }
}

template <class T>
void add_type(const std::string& type, int bits = 53) {
  add_type<T>(type, bits, std::make_index_sequence<kOperations.size()>());
}

bool add_all() {
  add_type<double>("double");
  add_type<FastInterval>("fast");
  add_type<BoostInterval>("boost");
  add_type<UnroundedInterval>("unrounded");
  add_type<MpfrInterval>("mpfr53", 53);
  add_type<MpfrInterval>("mpfr212", 212);
  add_affine<ChebyshevAffine>("affine_chebyshev");
  add_affine<MinRangeAffine>("affine_min_range");
  return true;
}

[[maybe_unused]] const bool kAdded = add_all();

}  // namespace
}  // namespace gcslab
