#pragma once

// The project's own random numbers: the same on every machine, compiler and number of threads.
//
// A generator is seeded by a number and the name of the component that draws from it, never by time or
// thread, so that adding a component does not change what another one draws. Generator: xoshiro256**
// (Blackman, Vigna 2018), state filled by splitmix64.

#include <array>
#include <cstdint>
#include <string_view>

namespace gcslab {

class Random {
 public:
  /// The stream of `component` under `seed`.
  Random(std::uint64_t seed, std::string_view component);

  /// Uniform over all 64-bit words.
  std::uint64_t next();
  /// Uniform in [0, bound), without bias; bound > 0.
  std::uint64_t below(std::uint64_t bound);
  /// Uniform over the integers of [low, high].
  std::int64_t integer(std::int64_t low, std::int64_t high);
  /// Uniform over the multiples of 2^-53 in [0, 1).
  double unit();
  /// low + (high - low) * unit(), kept inside [low, high].
  double uniform(double low, double high);

 private:
  std::array<std::uint64_t, 4> state_;
};

}  // namespace gcslab
