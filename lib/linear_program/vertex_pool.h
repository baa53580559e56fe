#pragma once

// Vertices of one polytope that were optimal for earlier objectives, as places to start from.
//
// The optimum for min x_3 is often a few edges from an earlier one, though seldom from the last: starting
// from the best of all halves the steps of a reduction. The pool is bounded in memory; the oldest vertex goes
// first.

#include <cstddef>
#include <span>
#include <vector>

#include "linear_program/simplex_vertex.h"

namespace gcslab {

class VertexPool {
 public:
  /// Forgets the vertices but keeps their memory.
  void clear() {
    used_ = 0;
    next_ = 0;
  }
  void remember(const SimplexVertex& vertex);
  /// The vertex of least cost, when that is less than `below`; else nullptr.
  const SimplexVertex* best(std::span<const double> cost, double below) const;

 private:
  std::vector<SimplexVertex> vertices_;
  std::size_t used_ = 0;
  std::size_t next_ = 0;
};

/// cost . x at a vertex.
double cost_at(const SimplexVertex& vertex, std::span<const double> cost);

}  // namespace gcslab
