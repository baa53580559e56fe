#pragma once

// Random triangulations of a triangle, the same on every machine.
//
// First every vertex goes into an inner face that is drawn uniformly (a random Apollonian network: Zhou, Yan,
// Wang 2005); then edges drawn uniformly are flipped where that keeps the graph simple. A flip and the one
// that undoes it are equally probable, so that many of them take the network towards the uniform law over the
// triangulations that flips reach.

#include <cstdint>

#include "packing/triangulation.h"

namespace gcslab {

struct RandomTriangulationOptions {
  int inner_vertices = 6;
  int flips = 100;  ///< tried, not all possible
  std::uint64_t seed = 1;
};

Triangulation random_triangulation(const RandomTriangulationOptions& options);

}  // namespace gcslab
