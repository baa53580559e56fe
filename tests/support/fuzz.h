#pragma once

// How much random testing to do, and from which seed.

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <string>

namespace gcslab {

/// The number of random cases: GCSLAB_FUZZ_CASES, or the default of the test.
inline std::size_t fuzz_cases(std::size_t default_cases) {
  const char* text = std::getenv("GCSLAB_FUZZ_CASES");
  return text == nullptr ? default_cases : std::stoull(text);
}

/// The seed of random cases: GCSLAB_FUZZ_SEED, or 1. Printed, so that a failure can be repeated.
inline std::uint64_t fuzz_seed() {
  const char* text = std::getenv("GCSLAB_FUZZ_SEED");
  const std::uint64_t seed = text == nullptr ? 1 : std::stoull(text);
  std::cout << "seed " << seed << " (GCSLAB_FUZZ_SEED)\n";
  return seed;
}

}  // namespace gcslab
