#pragma once

// Contractors shrink a box without losing a root: the exchangeable parts of branch and prune.

#include <memory>
#include <string>
#include <vector>

#include "box_solver/proof_step.h"
#include "certification/system_functions.h"
#include "interval/interval.h"

namespace gcslab {

/// A contractor belongs to one thread. It keeps no memory of earlier boxes that its result depends on.
class Contractor {
 public:
  virtual ~Contractor() = default;

  /// Shrinks `box`, which is bounded or not, but not empty. Promise: every solution of the system in the box
  /// before is in the box after. False means that there is none; the box is then without meaning. Each
  /// narrowing is told to `trace`.
  [[nodiscard]] virtual bool contract(Box& box, ProofTrace& trace) = 0;
};

/// How much smaller a box became: the largest relative loss of a side, in [0, 1].
double largest_gain(const Box& before, const Box& after);

}  // namespace gcslab
