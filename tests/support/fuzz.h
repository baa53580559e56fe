#pragma once

// How much random testing to do, and from which seed.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <string>

namespace gcslab {

/// The number of random cases: GCSLAB_FUZZ_CASES, or the default of the test; never more than
/// GCSLAB_FUZZ_AT_MOST, by which slow builds do less of what is much without doing more of what is little.
inline std::size_t fuzz_cases(std::size_t default_cases) {
  const char* cases = std::getenv("GCSLAB_FUZZ_CASES");
  const char* at_most = std::getenv("GCSLAB_FUZZ_AT_MOST");
  const std::size_t wanted = cases == nullptr ? default_cases : std::stoull(cases);
  return at_most == nullptr ? wanted : std::min<std::size_t>(wanted, std::stoull(at_most));
}

/// The seed of random cases: GCSLAB_FUZZ_SEED, or 1. Printed, so that a failure can be repeated.
inline std::uint64_t fuzz_seed() {
  const char* text = std::getenv("GCSLAB_FUZZ_SEED");
  const std::uint64_t seed = text == nullptr ? 1 : std::stoull(text);
  std::cout << "seed " << seed << " (GCSLAB_FUZZ_SEED)\n";
  return seed;
}

}  // namespace gcslab
